/// @file
/// Exercise 1.1, warm-up: One step late
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// A ball's return to the ground that it was thrown from.
struct Landing {
  Real time;   ///< since the throw [s]
  Real speed;  ///< downwards [m/s]
};

/// Where explicit Euler (1.3) lands a ball that is thrown straight up at `speed` [m/s]
/// against the gravity g [m/s²], in steps of dt [s]. 2 speed/(g dt) is a whole number,
/// so that one of the steps ends on the ground.
Landing explicit_euler_landing(Real speed, Real g, Real dt);

}  // namespace timestep
