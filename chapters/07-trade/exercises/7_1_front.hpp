/// @file
/// Exercise 7.1, warm-up: Nobody is better
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/physics/real.hpp"

namespace timestep {

/// What a run cost and how wrong it was, each in a unit of its own. The error of a run
/// that failed is infinite or NaN.
struct Measured {
  Real cost, error;
};

/// The Pareto front: the indices of the runs than which no other is better, the
/// cheapest first. One run is better than another if it is no worse in cost and in
/// error, and less in one of them. Of runs that are equal in both, the first alone
/// counts. A run that failed is never on the front.
std::vector<std::size_t> pareto_front(std::span<const Measured> runs);

}  // namespace timestep
