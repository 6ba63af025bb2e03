/// @file
/// Who is worth looking at: the records that no other beats in both error and cost.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "study/record.hpp"

namespace timestep::study {

/// The cost that is compared.
enum class Cost { time, evaluations };

/// The Pareto front of one problem's records, the cheapest first: every other record
/// costs as much or more and errs as much or more. Of equal ones the first stands. What
/// failed, or has no such cost, is not on it. `frame` [s] is the problem's.
std::vector<const Record*> front(std::span<const Record* const> records, Cost cost,
                                 double frame);

}  // namespace timestep::study
