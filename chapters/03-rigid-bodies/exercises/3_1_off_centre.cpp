// Below, the torque is taken about the world's origin, the box is taken for a ball, and
// the bat is hit in its middle. Mend all three.
//
// Hints: the lever in (3.5) begins at the centre of mass. The moments of a box are the
// first of (3.8), and they are its own: take the torque to the box's axes, divide by
// them, and bring the result back. `q * v` takes a vector to the world frame, and
// `glm::conjugate(q) * v` takes it to the box's.
//
// For the bat, let a force F act at x. The whole bat accelerates by F/m, and it begins
// to turn. What does the turning do to the held end?
#include "chapters/03-rigid-bodies/exercises/3_1_off_centre.hpp"

namespace timestep {

Vec3 torque(const Vec3& force, const Vec3& point, [[maybe_unused]] const Vec3& centre) {
  return glm::cross(point, force);
}

Vec3 angular_acceleration(Real mass, const Vec3& size, [[maybe_unused]] const Quat& q,
                          const Vec3& tau) {
  return tau / (mass * glm::dot(size, size) / 10);
}

Real sweet_spot([[maybe_unused]] const Vec3& size) {
  return 0;
}

}  // namespace timestep
