/// @file
/// Exercise 2.4, core: Drag at the end, solved by hand
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// A step of dt [s] of velocity Verlet whose last half kick takes the drag of the
/// velocity that it leads to, (2.11), for a ball at x [m] and v [m/s] in gravity g
/// [m/s²], linear drag of the rate b = c/m >= 0 [1/s] and quadratic drag q = k/m >= 0
/// [1/m]: v' = g - b v - q |v| v.
void fall_step(Vec3& x, Vec3& v, const Vec3& g, Real b, Real q, Real dt);

}  // namespace timestep
