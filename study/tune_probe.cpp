// What a setting must also stand: steps and starts beside its own.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "study/chapters.hpp"
#include "study/tune.hpp"

namespace timestep::study {
namespace {

// Numbers that say how a scene starts: the first that it has, and that is not 0, is
// changed
constexpr std::array<std::string_view, 23> k_starts{
    "spin_y", "speed",   "stretch", "theta",    "theta1",  "eccentricity",
    "angle",  "omega1",  "spin",    "tumble",   "impulse", "height",
    "lift",   "tilt",    "overlap", "depth",    "depth_x", "swing",
    "offset", "spacing", "ratio",   "friction", "torque"};

// A setting that fails at one seed of five passes all of them once in six times
constexpr int k_seeds = 8;

Probe with_step(const Cell& cell, double factor) {
  Probe probe{fmt::format("dt x {}", factor), cell};
  probe.cell.dt = factor * cell.dt;
  return probe;
}

Probe with_seed(const Cell& cell, double seed) {
  Probe probe{fmt::format("seed = {}", seed), cell};
  probe.cell.settings["seed"] = seed;
  return probe;
}

Probe with_factor(const Cell& cell, const std::string& name, double factor) {
  Probe probe{fmt::format("{} x {:.5g}", name, factor), cell};
  probe.cell.settings[name] = factor * setting(cell, name);
  return probe;
}

// `share` of a number to either side; at the end of its range, one and a half times as
// much to the side that is left
std::vector<Probe> around(const Cell& cell, const Parameter& parameter, double share) {
  const double value = setting(cell, parameter.name);
  std::vector<Probe> probes;
  for (const double side : {-share, share}) {
    const double moved = (1 + side) * value;
    const bool fits = parameter.minimum <= moved && moved <= parameter.maximum;
    probes.push_back(
        with_factor(cell, parameter.name, 1 + (fits ? side : -1.5 * side)));
  }
  return probes;
}

// The seeds from `first` after the cell's own on, or `share` of a number to either side
std::vector<Probe> starts(const Cell& cell, int first, double share) {
  const std::vector<Parameter>& all = scene_of(*cell.problem).parameters;
  const auto named = [&](std::string_view name) {
    return std::ranges::find(all, name, &Parameter::name);
  };
  if (const auto seed = named("seed"); seed != all.end()) {
    std::vector<Probe> probes;
    for (int i = first; i < first + k_seeds; ++i)
      probes.push_back(with_seed(cell, setting(cell, "seed") + i));
    return probes;
  }
  for (const std::string_view name : k_starts) {
    const auto found = named(name);
    if (found == all.end() || setting(cell, found->name) == 0) continue;
    return around(cell, *found, share);
  }
  return {};
}

}  // namespace

double setting(const Cell& cell, const std::string& name) {
  const auto found = cell.settings.find(name);
  if (found != cell.settings.end()) return found->second;
  const std::vector<Parameter>& all = scene_of(*cell.problem).parameters;
  const auto parameter = std::ranges::find(all, name, &Parameter::name);
  if (parameter == all.end()) throw std::out_of_range("there is no parameter " + name);
  return parameter->value;
}

std::vector<Probe> neighbours(const Cell& cell) {
  return {with_step(cell, 0.97), with_step(cell, 1.03)};
}

std::vector<Probe> other_starts(const Cell& cell) {
  return starts(cell, 1, 0.01);
}

std::vector<Probe> fresh_starts(const Cell& cell) {
  return starts(cell, 1 + k_seeds, 0.005);
}

}  // namespace timestep::study
