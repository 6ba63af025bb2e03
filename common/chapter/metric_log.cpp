#include "common/chapter/metric_log.hpp"

#include <algorithm>
#include <cmath>

namespace timestep {
namespace {

constexpr std::size_t k_most_entries = 600;

}  // namespace

void MetricLog::add(double time, std::span<const Lane> lanes) {
  if (entries_.empty()) {
    metrics_ = lanes.front().metrics;
    for (const Lane& lane : lanes) setups_.push_back(*lane.setup);
  }
  if (++skipped_ < stride_ && !entries_.empty()) return;
  skipped_ = 0;

  Entry entry{.time = time, .values = {}};
  for (const Lane& lane : lanes) {
    std::vector<double>& values = entry.values.emplace_back();
    if (lane.failure) continue;
    for (const Metric& metric : lane.metrics) values.push_back(metric.value);
  }
  entries_.push_back(std::move(entry));
  if (entries_.size() > k_most_entries) thin();
}

void MetricLog::thin() {
  for (std::size_t i = 0; 2 * i < entries_.size(); ++i) {
    if (i > 0) entries_[i] = std::move(entries_[2 * i]);
  }
  entries_.resize((entries_.size() + 1) / 2);
  stride_ *= 2;
}

Chart MetricLog::chart(const std::string& metric, bool logarithmic) const {
  const auto found = std::ranges::find(metrics_, metric, &Metric::name);
  if (found == metrics_.end()) return {};
  const auto index = static_cast<std::size_t>(found - metrics_.begin());

  Chart chart{.title = metric,
              .x_label = "time [s]",
              .y_label = found->unit.empty() ? "" : "[" + found->unit + "]",
              .logarithmic_y = logarithmic,
              .series = {}};
  for (std::size_t lane = 0; lane < setups_.size(); ++lane) {
    ChartSeries series{setups_[lane].method, setups_[lane].style, {}};
    for (const Entry& entry : entries_) {
      if (index >= entry.values[lane].size()) continue;
      const double value = entry.values[lane][index];
      const bool shown = std::isfinite(value) && (!logarithmic || value > 0);
      if (shown) series.points.emplace_back(entry.time, value);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace timestep
