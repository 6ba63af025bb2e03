/// @file
/// Exercise 3.5, challenge: When it flips
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

// All in the body frame, along the principal axes, in any order. I: principal moments
// [kg m²], all different. No torque acts.

/// The axis, 0 to 2, about which a body does not turn steadily.
int unstable_axis(const Vec3& I);

/// The rate sigma [1/s] with which a small wobble grows as exp(sigma t), while the body
/// turns about that axis at W [rad/s].
Real growth_rate(const Vec3& I, Real W);

/// (3.32) The time [s] from one flip of a body that turns at omega [rad/s] to the next:
/// a flip is where the angular velocity about the unstable axis changes sign. Whatever
/// wobbles has flips at even intervals, small ones near a stable axis. Infinite if
/// omega is along the unstable axis; it is never along a stable one.
Real flip_interval(const Vec3& I, const Vec3& omega);

}  // namespace timestep
