// Below is a step of Euler's. With b dt beyond 1 it turns the velocity round, beyond 2
// it makes it grow. Replace it by the exact solution of v' = g - b v.
//
// Hint: x(t) is in (1.15); its derivative is v(t). Then look at b = 0, where a formula
// may divide zero by zero, and at a tiny b, where 1 - std::exp(-b * dt) has few digits
// left: std::expm1(z) is e^z - 1 to the last digit.
#include "chapters/01-particles/exercises/1_2_fall.hpp"

namespace timestep {

Vec3 fall_velocity(const Vec3& v, const Vec3& g, Real b, Real dt) {
  return v + dt * (g - b * v);
}

}  // namespace timestep
