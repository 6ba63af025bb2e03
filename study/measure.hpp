/// @file
/// Runs one cell: once for its error, and in a pass of its own some times for its time.
#pragma once

#include <string>

#include "common/chapter/plan.hpp"
#include "study/cell.hpp"
#include "study/timing.hpp"

namespace timestep::study {

/// The error of a run and its exact cost. With `failed`, words that say when and why
/// the run ended early, the error is NaN and the counts are those until then.
struct ErrorResult {
  double error = 0;
  std::string unit{};
  long long evaluations = 0, steps = 0, bodies = 0;
  std::string failed{};
};

/// The cell as the chapter's executable plans it. Throws InputError, as that does, if
/// the chapter does not know a name or refuses a value.
Plan plan_of(const Cell& cell);

/// The same bits at every call. Throws Interrupted after Ctrl+C, and what `plan_of`
/// throws.
ErrorResult measure_error(const Cell& cell);

/// As `time_of` times it; NaN if a step cannot be taken. Throws as `measure_error`.
TimeResult measure_time(const Cell& cell, int least_repeats = 3);

}  // namespace timestep::study
