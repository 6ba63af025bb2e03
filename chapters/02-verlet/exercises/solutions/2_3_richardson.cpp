// coarse - middle is 2^p times middle - fine, and coarse - fine is 2^p - 1 times the
// error of fine. The method's own next term is left: dt^(p+1), or dt^(p+2) where the
// step is its own mirror image, so that two Verlets make a fourth order, as in (2.16),
// for the price of three looks a dt. That end is no longer symplectic: extrapolate what
// you report, and go on from what Verlet gave you.
#include "chapters/02-verlet/exercises/2_3_richardson.hpp"

#include <cmath>

namespace timestep {

Real observed_order(Real coarse, Real middle, Real fine) {
  return std::log2((coarse - middle) / (middle - fine));
}

Real extrapolated(Real coarse, Real fine, Real p) {
  return fine + (fine - coarse) / (std::exp2(p) - 1);
}

}  // namespace timestep
