// Below is modified Euler (1.5), which is of first order. Formula 3 of the thesis moves
// the position in the same way, but the velocity with the mean of the accelerations at
// the start and at the end of the step. That one change makes it velocity Verlet (2.6).
//
// Hint: `acceleration` overwrites a. What of the old a is still needed after the call,
// and where could it wait?
#include "chapters/02-verlet/exercises/2_1_formula_3.hpp"

namespace timestep {

void formula_3(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += v[i] * dt + a[i] * dt * dt / 2;
    v[i] += a[i] * dt;
  }
  acceleration(x, v, t + dt, a);
}

}  // namespace timestep
