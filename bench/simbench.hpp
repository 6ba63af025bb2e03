/// @file
/// SimBenchmark's scenes with its parameters and its measures of error, over steps and
/// iterations. Source: D. Kang, J. Hwangbo, SimBenchmark, 2018; its steps below 1e-4 s
/// of `bouncing` and 1e-3 s of the two of 216 balls, and more than 300 iterations, are
/// left out: they take up to hours.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/world_measures.hpp"

namespace timestep::world_bench {

/// A scene and what is varied in it.
struct SimbenchScene {
  std::string name;
  Scene scene;
  double duration;                 ///< [s]
  std::vector<Settings> settings;  ///< of one step, or one number of iterations, each
  bool is_by_iterations;
  std::function<double(double t, std::span<const State>)> error;
};

/// rolling, rolling_diagonal, bouncing, 666, elastic_666. Quick ones last a fiftieth of
/// the time, at 10 ms and more, and mean nothing.
std::vector<SimbenchScene> simbench_scenes(bool is_quick);

}  // namespace timestep::world_bench
