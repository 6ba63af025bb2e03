/// @file
/// Exercise 3.1, core: A box hit off-centre
#pragma once

#include "common/physics/quaternion.hpp"

namespace timestep {

/// (3.5) Torque [N m] about a body's centre of mass [m] of a force [N] at a point [m],
/// all in the world frame.
Vec3 torque(const Vec3& force, const Vec3& point, const Vec3& centre);

/// Angular acceleration [rad/s²], world frame, of a box at rest under a torque tau [N
/// m], world frame. The box has an even density, a mass [kg], edges of `size` [m] along
/// its own axes, and stands as q, world from body, says.
Vec3 angular_acceleration(Real mass, const Vec3& size, const Quat& q, const Vec3& tau);

/// A bat is a box of size.x along x, held in the middle of its end at x = -size.x/2 and
/// hit along y in its middle plane. At which x [m] from its centre must it be hit, so
/// that the held end's middle does not begin to move?
Real sweet_spot(const Vec3& size);

}  // namespace timestep
