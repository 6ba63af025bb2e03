/// @file
/// Exercise 6.2, core: The sweet spot of a bat
#pragma once

#include "common/physics/rigid_body.hpp"

namespace timestep {

/// A bat lies along its own x axis, at rest. A hand holds it at x = grip [m] from its
/// centre of mass, grip < 0. Returns the place x [m] at which a blow along `direction`,
/// a unit vector of the world at a right angle to the bat, gives the hand's place no
/// velocity in that direction. Hands know it as the sweet spot.
Real sweet_spot(const RigidBody& bat, Real grip, const Vec3& direction);

}  // namespace timestep
