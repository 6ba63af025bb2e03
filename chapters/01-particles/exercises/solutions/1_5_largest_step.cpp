// -x = x - v dt gives x = v dt/2; with it -v = v - (k x + c v) dt/m becomes
// k dt² + 2 c dt - 4 m = 0. Its root (sqrt(c² + 4 k m) - c)/k loses its digits in
// strong drag; multiplied out with the conjugate it does not. c = 0 gives (1.20), k = 0
// the limit of drag.
#include "chapters/01-particles/exercises/1_5_largest_step.hpp"

#include <cmath>

namespace timestep {

Real largest_step(Real m, Real k, Real c) {
  return 4 * m / (c + std::sqrt(c * c + 4 * k * m));
}

}  // namespace timestep
