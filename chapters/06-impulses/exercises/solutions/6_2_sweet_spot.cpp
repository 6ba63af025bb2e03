// With e the direction of the bat and d that of the blow, a blow of 1 N s at x turns
// the bat by I⁻¹ (x e × d), which moves the grip at g by that × g e. Along d it is g x
// (e × d) · I⁻¹ (e × d): a scalar product, since a × b · d is a · b × d. Together with
// 1 / m it has to be 0. The share of I⁻¹ is the angular part of the effective mass
// (6.2), but between two places: the hand feels nothing where a blow at the one place
// is worth nothing at the other.
#include "chapters/06-impulses/exercises/6_2_sweet_spot.hpp"

namespace timestep {

Real sweet_spot(const RigidBody& bat, Real grip, const Vec3& direction) {
  const Vec3 along = turned_by(bat.orientation, Vec3(1, 0, 0));
  const Vec3 axis = glm::cross(along, direction);
  const Real turn = glm::dot(axis, world_inverse_inertia(bat) * axis);
  return -bat.inverse_mass / (grip * turn);
}

}  // namespace timestep
