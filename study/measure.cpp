#include "study/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "common/chapter/runner.hpp"
#include "study/chapters.hpp"

namespace timestep::study {
namespace {

/// The metric of that name; throws std::out_of_range if the scene has none.
const Metric& metric_named(const Lane& lane, const std::string& name) {
  const auto found = std::ranges::find(lane.metrics, name, &Metric::name);
  if (found == lane.metrics.end())
    throw std::out_of_range("there is no metric " + name);
  return *found;
}

}  // namespace

Plan plan_of(const Cell& cell) {
  Choice choice{.scene = cell.problem->scene,
                .methods = {cell.method},
                .precision = cell.precision,
                .dt = exact_text(cell.dt),
                .duration = exact_text(cell.problem->duration)};
  for (const auto& [name, value] : cell.settings)
    choice.settings.emplace_back(name, exact_text(value));
  return make_plan(chapter_named(cell.problem->chapter), choice);
}

ErrorResult measure_error(const Cell& cell) {
  const Plan plan = plan_of(cell);
  std::vector<Lane> lanes = start_lanes(plan);
  run_lanes(plan, lanes, {}, [](double) {});
  const Lane& lane = lanes.front();

  const Metric& metric = metric_named(lane, cell.problem->metric);
  ErrorResult result{.error = std::numeric_limits<double>::quiet_NaN(),
                     .unit = metric.unit,
                     .evaluations = lane.simulation->evaluations(),
                     .steps = lane.steps,
                     .bodies = lane.simulation->body_count(),
                     .failed = {}};
  if (lane.failure) {
    result.failed =
        fmt::format("at {} s: {}", short_text(lane.failure->time), lane.failure->what);
    return result;
  }
  const std::string& known = cell.problem->known;
  const double should = known.empty() ? 0 : metric_named(lane, known).value;
  result.error = std::abs(metric.value - should);
  return result;
}

TimeResult measure_time(const Cell& cell, int least_repeats) {
  const Plan plan = plan_of(cell);
  const auto start = [&] {
    auto run = plan.scene->start(plan.setups.front());
    run->observe();
    return timed_run(std::move(run));
  };
  try {
    return time_of(start, {.steps = plan.steps,
                           .frames_per_step = cell.dt / cell.problem->frame,
                           .least_repeats = least_repeats});
  } catch (const StepFailure&) {
    return {.us_per_frame = std::numeric_limits<double>::quiet_NaN()};
  }
}

}  // namespace timestep::study
