#include "common/physics/rounding.hpp"

#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {

Real spacing(Real value) {
  const Real magnitude = std::abs(value);
  return std::nextafter(magnitude, std::numeric_limits<Real>::infinity()) - magnitude;
}

Real accumulated_time(Real dt, long long n) {
  Real t = 0;
  for (long long i = 0; i < n; ++i) t += dt;
  return t;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
