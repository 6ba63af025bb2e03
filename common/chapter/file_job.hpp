/// @file
/// What a chapter does with a file instead of simulating.
#pragma once

#include "common/chapter/options.hpp"

namespace timestep {

/// Runs the job that the options name (`options.job`) and writes its results: to the
/// file of `--results`, to standard output if that is `-`, or to results.json in the
/// folder of `--out`. They appear whole or not at all. Throws InputError for an unknown
/// method or precision, for more than one method, for what the job finds wrong with its
/// file, and for a place that cannot be written; Interrupted after Ctrl+C.
void run_file_job(const Chapter& chapter, const Options& options);

}  // namespace timestep
