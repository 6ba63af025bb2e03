/// @file
/// Every metric of every method over time, thinned so that it never grows large.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/chapter/runner.hpp"
#include "common/graphics/draw_list.hpp"

namespace timestep {

/// The past of a run, for graphs. Of a method that failed nothing more is added.
class MetricLog {
 public:
  /// Adds the lanes' latest samples at `time` [s].
  void add(double time, std::span<const Lane> lanes);

  /// The graph of one metric over time, a line a method; values that are not finite, or
  /// not positive on a logarithmic axis, are left out.
  Chart chart(const std::string& metric, bool logarithmic) const;

 private:
  struct Entry {
    double time = 0;
    std::vector<std::vector<double>> values;  // by lane, by metric; empty if failed
  };

  void thin();

  std::vector<Setup> setups_;
  std::vector<Metric> metrics_;
  std::vector<Entry> entries_;
  int stride_ = 1, skipped_ = 0;
};

}  // namespace timestep
