#include "study/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "common/chapter/interrupt.hpp"
#include "study/quantile.hpp"

namespace timestep::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double k_longest_run = 0.02;     // [s]
constexpr double k_shortest_block = 5e-5;  // [s] below it, reading the clock is seen
constexpr double k_enough = 0.01;          // [s] of runs, with what starting them takes
constexpr int k_most_runs = 200;
constexpr double k_steady = 0.1;  // spread above which it goes on
constexpr int k_patience = 5;     // times as long at most

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// How far a run gets in the longest time, how long that took, and how long its start.
struct Pilot {
  long long steps = 0;
  double seconds = 0, start_seconds = 0;
};

Pilot fly(const std::function<TimedRun()>& start, long long most_steps) {
  Pilot pilot;
  const auto before = Clock::now();
  const TimedRun run = start();
  pilot.start_seconds = seconds_since(before);
  const auto begin = Clock::now();
  while (pilot.steps < most_steps && pilot.seconds < k_longest_run) {
    run(1);
    ++pilot.steps;
    pilot.seconds = seconds_since(begin);
  }
  return pilot;
}

/// How many runs make a block whose time can be read off the clock, if starting them
/// does not take too long.
int block_length(const Pilot& pilot) {
  const double wanted = std::ceil(k_shortest_block / std::max(pilot.seconds, 1e-7));
  const double most = std::floor(k_enough / std::max(pilot.start_seconds, 1e-7));
  return static_cast<int>(std::clamp(std::min(wanted, most), 1.0, 100.0));
}

/// Time of one run of so many steps [s], the mean of `count` runs in one block.
double time_of_block(const std::function<TimedRun()>& start, long long steps,
                     int count) {
  std::vector<TimedRun> runs;
  for (int i = 0; i < count; ++i) runs.push_back(start());
  const auto begin = Clock::now();
  for (const TimedRun& run : runs) run(steps);
  return seconds_since(begin) / count;
}

double spread_of(const std::vector<double>& times) {
  return (quantile(times, 0.75) - quantile(times, 0.25)) / quantile(times, 0.5);
}

/// Whether so many times the usual runs are timed.
bool reaches(int times, int runs, double seconds, int least) {
  return runs >= times * least
         && (runs >= times * k_most_runs || seconds >= times * k_enough);
}

}  // namespace

TimeResult time_of(const std::function<TimedRun()>& start, const Timing& timing) {
  const Pilot pilot = fly(start, timing.steps);
  const int count = block_length(pilot);
  std::vector<double> times;
  const auto begin = Clock::now();
  const auto reached = [&](int factor) {
    return reaches(factor, static_cast<int>(times.size()), seconds_since(begin),
                   timing.least_repeats);
  };
  while (!reached(1) || (!reached(k_patience) && spread_of(times) > k_steady)) {
    throw_if_interrupted();
    times.push_back(time_of_block(start, pilot.steps, count));
  }
  const double frames = static_cast<double>(pilot.steps) * timing.frames_per_step;
  return {.us_per_frame = 1e6 * quantile(times, 0.5) / frames,
          .repeats = static_cast<int>(times.size()),
          .spread = spread_of(times)};
}

double expected_timing(double run_seconds, int least_repeats) {
  const double run = std::min(run_seconds, k_longest_run);
  return run + std::max(k_enough, least_repeats * run);
}

}  // namespace timestep::study
