/// @file
/// Exercise 3.3, core: The term that Listing 3 lacks
#pragma once

#include "common/physics/rotation.hpp"

namespace timestep {

/// (3.14) Angular acceleration [rad/s²] of a body with principal moments I [kg m²] that
/// turns at omega [rad/s] under a torque tau [N m], all in the body frame.
Vec3 angular_acceleration(const Vec3& omega, const Vec3& I, const Vec3& tau);

/// A step of dt [s] of a body without torque. Keeps the angular momentum in the world
/// (3.13), in length and direction, to rounding; the error of the attitude after a
/// fixed time falls with dt².
void free_step(Rotation& r, const Vec3& I, Real dt);

}  // namespace timestep
