/// @file
/// Exercise 1.2, core: A fall that no step can break
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// The exact velocity [m/s] after a step of dt [s], from v [m/s], in gravity g [m/s²]
/// and linear drag of the rate b = c/m >= 0 [1/s].
Vec3 fall_velocity(const Vec3& v, const Vec3& g, Real b, Real dt);

}  // namespace timestep
