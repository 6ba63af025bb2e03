/// @file
/// The time of a run, by one rule for the chapters' methods and for other libraries'.
#pragma once

#include <functional>
#include <memory>

namespace timestep::study {

/// What a frame costs: the median of `repeats` runs of step() alone.
struct TimeResult {
  double us_per_frame = 0;  ///< [µs]; NaN if a step cannot be taken
  int repeats = 0;          ///< how many runs were timed
  double spread = 0;        ///< range between the quartiles, over the median
};

/// A run at its start, as what takes so many steps of it.
using TimedRun = std::function<void(long long steps)>;

template <class Run>
TimedRun timed_run(std::unique_ptr<Run> run) {
  return [run = std::shared_ptr<Run>(std::move(run))](long long steps) {
    for (long long i = 0; i < steps; ++i) run->step();
  };
}

/// How long a run is, and how often it is timed at least.
struct Timing {
  long long steps = 0;
  double frames_per_step = 1;
  int least_repeats = 3;
};

/// Times runs that `start` starts alike: at least `least_repeats`, more while they are
/// short, and up to five times as many while they spread. A run that would take longer
/// than 20 ms is only timed as far as it gets in that time. Throws Interrupted after
/// Ctrl+C, and what a step throws.
TimeResult time_of(const std::function<TimedRun()>& start, const Timing& timing);

/// What `time_of` takes, roughly, for a run of so many seconds [s].
double expected_timing(double run_seconds, int least_repeats);

}  // namespace timestep::study
