// Below are the energies, which velocity Verlet does not keep. Find what it does keep.
//
// Hints, for the spring: take one step of (2.6) from x = 1, v = 0 and one from x = 0,
// v = omega on paper. That is the matrix (2.32), and (2.35) says what it keeps.
//
// For the pendulum nothing is kept exactly, but of all sums
//   energy + dt² (A omega0² cos(theta) omega² + B omega0⁴ sin²(theta))
// one changes far less than the others, by dt⁴. Small swings are those of a spring:
// that gives A - B. For A let the pendulum turn so fast that omega0⁴ does not count,
// and expand the energy after a step up to dt³. Or try: A is one over a whole number,
// and the test says by how much your sum changes.
#include "chapters/02-verlet/exercises/2_2_kept_energy.hpp"

#include <cmath>

namespace timestep {

Real kept_on_spring(Real m, Real k, Real x, Real v, [[maybe_unused]] Real dt) {
  return m * v * v / 2 + k * x * x / 2;
}

Real kept_on_pendulum(Real omega0, Real theta, Real omega, [[maybe_unused]] Real dt) {
  return omega * omega / 2 - omega0 * omega0 * std::cos(theta);
}

}  // namespace timestep
