#include "study/peers/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "study/chapters.hpp"

namespace timestep::study {
namespace {

// The same run by one of the scene's own methods: its parameters, its steps, its unit
Plan plan_of_scene(const Cell& cell) {
  Cell own = cell;
  own.method = scene_of(*cell.problem).methods.front().name;
  own.precision = "double";
  return plan_of(own);
}

std::unique_ptr<PeerRun> start(const Peer& peer, const Cell& cell, const Plan& plan) {
  const auto iterations = cell.settings.find("iterations");
  const bool is_set = peer.iterates && iterations != cell.settings.end();
  return peer.start({.problem = cell.problem,
                     .scene = plan.scene,
                     .dt = cell.dt,
                     .parameters = plan.setups.front().parameters,
                     .iterations = is_set ? static_cast<int>(iterations->second) : 0});
}

std::string unit_of(const Plan& plan, const std::string& metric) {
  const auto own = plan.scene->start(plan.setups.front());
  const std::vector<Metric> metrics = own->metrics();
  return std::ranges::find(metrics, metric, &Metric::name)->unit;
}

}  // namespace

std::vector<Cell> cells_of(const Peer& peer, const Problem& problem, bool quick) {
  std::vector<Cell> all;
  const std::array<const Problem*, 1> one{&problem};
  for (Cell cell : cells(one, quick)) {
    cell.method = peer.method;
    cell.precision = peer.precision;
    std::erase_if(cell.settings, [&](const auto& setting) {
      return !problem.settings.contains(setting.first)
             && !(peer.iterates && setting.first == "iterations");
    });
    const bool is_full = !peer.iterates || cell.settings.contains("iterations");
    const bool is_new = std::ranges::count(all, key(cell), key) == 0;
    if (is_full && is_new) all.push_back(cell);
  }
  if (all.empty() || !start(peer, all.front(), plan_of_scene(all.front()))) return {};
  return all;
}

ErrorResult measure_error(const Peer& peer, const Cell& cell) {
  const Plan plan = plan_of_scene(cell);
  const auto run = start(peer, cell, plan);
  ErrorResult result{.error = std::numeric_limits<double>::quiet_NaN(),
                     .unit = unit_of(plan, cell.problem->metric),
                     .evaluations = 0,
                     .bodies = run->bodies(),
                     .failed = {}};
  try {
    run->observe();
    for (; result.steps < plan.steps; ++result.steps) {
      run->step();
      run->observe();
    }
    result.error = run->error();
    if (!std::isfinite(result.error)) result.failed = "a number is not finite";
  } catch (const std::exception& error) {
    result.failed = error.what();
  }
  result.evaluations = run->evaluations();
  return result;
}

TimeResult measure_time(const Peer& peer, const Cell& cell, int least_repeats) {
  const Plan plan = plan_of_scene(cell);
  const auto start_one = [&] {
    auto run = start(peer, cell, plan);
    run->observe();
    return timed_run(std::move(run));
  };
  return time_of(start_one, {.steps = plan.steps,
                             .frames_per_step = cell.dt / cell.problem->frame,
                             .least_repeats = least_repeats});
}

}  // namespace timestep::study
