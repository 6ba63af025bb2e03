// As each order undoes the other with -dt, what this one keeps is (1.19) with -dt in
// the place of dt. The path is the same: here the velocity is half a step ahead of the
// position, in (1.4) half a step behind.
#include "chapters/01-particles/exercises/1_4_other_order.hpp"

namespace timestep {

void drift_kick(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * dt;

  // The acceleration at the new place and time
  acceleration(x, v, t + dt, a);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * dt;
}

Real kept_quantity(Real m, Real k, Real x, Real v, Real dt) {
  return m * v * v / 2 + k * x * x / 2 + k * dt * x * v / 2;
}

}  // namespace timestep
