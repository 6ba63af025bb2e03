// With A = D = 1 - z²/2, B = z and C = -z (1 - z²/4) in (2.35), Verlet keeps the energy
// of a weaker spring. At z = 2 nothing is left of the spring, and x may go anywhere.
//
// In any potential V, with m = 1, a step changes v²/2 + V by
//   -dt³ (V''' v³/12 - V' V'' v/4) = -dt d/dt (dt² (V'' v²/12 - V'²/24)),
// up to dt⁵, so the sum of both stays. Every symplectic method has such a series. On a
// spring it converges; elsewhere it does not, but its first terms hold for longer than
// anybody looks.
#include "chapters/02-verlet/exercises/2_2_kept_energy.hpp"

#include <cmath>

namespace timestep {

Real kept_on_spring(Real m, Real k, Real x, Real v, Real dt) {
  return m * v * v / 2 + (1 - k / m * dt * dt / 4) * k * x * x / 2;
}

Real kept_on_pendulum(Real omega0, Real theta, Real omega, Real dt) {
  // V = -c, V' = s, V'' = c
  const Real c = omega0 * omega0 * std::cos(theta);
  const Real s = omega0 * omega0 * std::sin(theta);
  return omega * omega / 2 - c + dt * dt * (c * omega * omega / 12 - s * s / 24);
}

}  // namespace timestep
