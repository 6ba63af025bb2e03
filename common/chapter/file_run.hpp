/// @file
/// A run without a window: numbers, tables and pictures, written when all are complete.
#pragma once

#include "common/chapter/options.hpp"
#include "common/chapter/plan.hpp"

namespace timestep {

/// Runs the plan and writes what the options ask for, pictures only if `pictures`. The
/// note, unless it is empty, is printed once everything is known to be in order. Throws
/// InputError if something cannot be written or, with pictures, drawn; Interrupted
/// after Ctrl+C; nothing is left behind then.
void run_to_files(const Plan& plan, const Options& options, bool pictures,
                  const std::string& note);

}  // namespace timestep
