// Below, the blow goes to the centre of mass. Then the bat does not turn, and the hand
// gets as fast as all of it.
//
// Hints: An impulse J at r from the centre of mass gives the velocity J / m, and the
// angular velocity I⁻¹ (r × J), by (6.8). So the velocity at the grip is a constant and
// something proportional to x, and it should be 0. `world_inverse_inertia(bat)` is I⁻¹,
// and `turned_by(bat.orientation, {1, 0, 0})` is the direction of the bat.
//
// A bat need not be round: the moment of inertia that counts is about the axis around
// which this blow turns it.
#include "chapters/06-impulses/exercises/6_2_sweet_spot.hpp"

namespace timestep {

Real sweet_spot([[maybe_unused]] const RigidBody& bat, [[maybe_unused]] Real grip,
                [[maybe_unused]] const Vec3& direction) {
  return 0;
}

}  // namespace timestep
