// Below are semi-implicit Euler (1.4), which moves the velocity first, and the energy,
// which neither order keeps. Turn the method round, then find what it keeps.
//
// Hints: an acceleration may depend on the time, so mind at which time you ask for it.
// Semi-implicit Euler keeps (1.19). A step of one order undoes a step of the other,
// taken backwards: with -dt.
#include "chapters/01-particles/exercises/1_4_other_order.hpp"

namespace timestep {

void drift_kick(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * dt;
    x[i] += v[i] * dt;
  }
}

Real kept_quantity(Real m, Real k, Real x, Real v, [[maybe_unused]] Real dt) {
  return m * v * v / 2 + k * x * x / 2;
}

}  // namespace timestep
