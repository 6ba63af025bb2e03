// The torque about the middle of the bat is x F, so its end at -size.x/2 accelerates by
// F/m - (x F / Iz) size.x/2. That is nothing where x = 2 Iz / (m size.x): a thin rod is
// hit two thirds of its length away from the hand, a cube five sixths. Hit further out
// and the hand is pulled backwards, further in and it is pushed along.
#include "chapters/03-rigid-bodies/exercises/3_1_off_centre.hpp"

namespace timestep {

Vec3 torque(const Vec3& force, const Vec3& point, const Vec3& centre) {
  return glm::cross(point - centre, force);
}

Vec3 angular_acceleration(Real mass, const Vec3& size, const Quat& q, const Vec3& tau) {
  // (3.8) A box
  const Vec3 s2 = size * size;
  const Vec3 I = mass / 12 * Vec3(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y);

  // (3.12) To the box's axes, and back
  return q * (glm::conjugate(q) * tau / I);
}

Real sweet_spot(const Vec3& size) {
  return (size.x * size.x + size.y * size.y) / (6 * size.x);
}

}  // namespace timestep
