/// @file
/// What a float does to time and place: the two numbers that every simulation should
/// know of its own precision. Source: chapter 1.
#pragma once

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (1.12) Distance from |value| to the next larger number that a Real can hold.
Real spacing(Real value);

/// (1.13) The clock that adds dt [s] n times, as a game loop does; what it should show
/// is n dt. Every addition rounds to the spacing at t.
Real accumulated_time(Real dt, long long n);

}  // namespace timestep::inline TIMESTEP_PRECISION
