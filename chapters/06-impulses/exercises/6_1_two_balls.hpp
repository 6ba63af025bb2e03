/// @file
/// Exercise 6.1, warm-up: Two balls collide
#pragma once

#include <array>

#include "common/physics/real.hpp"

namespace timestep {

/// A ball without spin. `inverse_mass` [1/kg] is 0 if nothing can move it.
struct Ball {
  Real inverse_mass;
  Vec3 position, velocity;  ///< [m], [m/s]
};

/// The velocities [m/s] of a and b just after they have met, without friction and with
/// the restitution e, 0 to 1. Balls that part already, or that cannot be moved, keep
/// theirs. Their centres are never in one place.
std::array<Vec3, 2> after_collision(const Ball& a, const Ball& b, Real e);

}  // namespace timestep
