/// @file
/// Exercise 2.3, core: Errors without the right answer
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// The order p of a method, from what it makes of the same motion in steps of dt, dt/2
/// and dt/4 (all in the same unit). It is off from the right answer by C dt^p, with C
/// and the right answer unknown.
Real observed_order(Real coarse, Real middle, Real fine);

/// The right answer, from the results of a method of the order p with steps of dt and
/// dt/2: Richardson's extrapolation.
Real extrapolated(Real coarse, Real fine, Real p);

}  // namespace timestep
