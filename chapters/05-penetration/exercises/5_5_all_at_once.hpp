/// @file
/// Exercise 5.5, challenge: All at once
#pragma once

#include <span>
#include <vector>

#include "common/physics/real.hpp"

namespace timestep {

/// A column of balls on the floor: ball i is depths[i] [m] in the one below, ball 0 in
/// the floor. What has each contact to push [kg m] for all depths to end at the same
/// time? A push p moves the ball above it up by p times its inverse mass [1/kg], and
/// the ball below down; nothing else moves. No depth is negative, no inverse mass 0.
std::vector<Real> pushes(std::span<const Real> inverse_masses,
                         std::span<const Real> depths);

}  // namespace timestep
