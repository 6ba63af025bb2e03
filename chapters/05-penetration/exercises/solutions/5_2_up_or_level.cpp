// After an impulse n the body turns with omega = I^-1 (r x n), and its point moves
// along n at n . (omega x r) on top of 1/m. A product of three vectors may be turned
// around: n . (omega x r) = omega . (r x n). So it is a quadratic form of r x n, never
// negative: a point can only be easier to move than the centre of mass.
#include "chapters/05-penetration/exercises/5_2_up_or_level.hpp"

namespace timestep {

Real inverse_mass_at(const RigidBody& body, const Vec3& arm, const Vec3& normal) {
  const Vec3 across = glm::cross(arm, normal);
  return body.inverse_mass + glm::dot(across, world_inverse_inertia(body) * across);
}

Motion push_by(const RigidBody& body, const Vec3& arm, const Vec3& normal,
               Real length) {
  const Vec3 push = length / inverse_mass_at(body, arm, normal) * normal;
  return {body.inverse_mass * push,
          world_inverse_inertia(body) * glm::cross(arm, push)};
}

}  // namespace timestep
