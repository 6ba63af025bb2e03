/// @file
/// Exercise 1.5, challenge: The largest step
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// The largest step [s] with which semi-implicit Euler (1.4) stays stable for a mass
/// m [kg] on a spring of stiffness k [N/m] in linear drag c [kg/s], a = -(k x + c v)/m.
/// k or c may be zero, not both.
Real largest_step(Real m, Real k, Real c);

}  // namespace timestep
