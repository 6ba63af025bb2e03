// The old acceleration's half waits in the velocity. Now x += v dt + a dt²/2 is
// x += (v + a dt/2) dt: put the half kick first, and (2.6) stands there.
#include "chapters/02-verlet/exercises/2_1_formula_3.hpp"

namespace timestep {

void formula_3(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += v[i] * dt + a[i] * dt * dt / 2;
    v[i] += a[i] * dt / 2;
  }

  // The mean's other half, with the acceleration at the new place and time
  acceleration(x, v, t + dt, a);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * dt / 2;
}

}  // namespace timestep
