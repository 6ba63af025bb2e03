#include "study/cell.hpp"

#include <algorithm>

#include "common/chapter/numbers.hpp"
#include "study/chapters.hpp"

namespace timestep::study {
namespace {

using Settings = std::map<std::string, double>;

std::vector<double> every_second(const std::vector<double>& values) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += 2) kept.push_back(values[i]);
  return kept;
}

/// All combinations of the axes that are varied for a method.
std::vector<Settings> combinations(const Problem& problem, const std::string& method,
                                   bool quick) {
  std::vector<Settings> all{problem.settings};
  for (const Axis& axis : problem.axes) {
    if (!axis.methods.empty() && !std::ranges::count(axis.methods, method)) continue;
    std::vector<Settings> longer;
    for (const Settings& before : all) {
      for (const double value : quick ? every_second(axis.values) : axis.values) {
        longer.push_back(before);
        longer.back()[axis.parameter] = value;
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<std::string> methods_of(const Problem& problem) {
  if (!problem.methods.empty()) return problem.methods;
  std::vector<std::string> names;
  for (const Method& method : scene_of(problem).methods) names.push_back(method.name);
  return names;
}

void add_cells(std::vector<Cell>& all, const Problem& problem, bool quick) {
  const std::vector<double> dts = quick ? every_second(problem.dts) : problem.dts;
  for (const std::string& method : methods_of(problem)) {
    const std::vector<Settings> settings = combinations(problem, method, quick);
    for (const char* precision : {"double", "single"})
      for (const double dt : dts)
        for (const Settings& each : settings)
          all.push_back({&problem, method, precision, dt, each});
  }
}

}  // namespace

std::string key(const Cell& cell) {
  std::string text = cell.problem->name + "/" + cell.method + "/" + cell.precision
                     + "/dt=" + exact_text(cell.dt);
  for (const auto& [name, value] : cell.settings) {
    const auto own = cell.problem->settings.find(name);
    const bool is_own = own != cell.problem->settings.end() && own->second == value;
    if (!is_own) text += "/" + name + "=" + exact_text(value);
  }
  return text;
}

std::vector<Cell> cells(std::span<const Problem* const> problems, bool quick) {
  std::vector<Cell> all;
  for (const Problem* problem : problems) add_cells(all, *problem, quick);
  return all;
}

std::vector<const Problem*> studied_problems(std::span<const std::string> names,
                                             bool quick) {
  std::vector<const Problem*> chosen = chosen_problems(names);
  if (quick && names.empty())
    std::erase_if(chosen, [](const Problem* problem) { return !problem->quick; });
  return chosen;
}

std::vector<Cell> shard_of(std::span<const Cell> cells, int shard, int shards) {
  std::vector<Cell> part;
  for (std::size_t i = static_cast<std::size_t>(shard) - 1; i < cells.size();
       i += static_cast<std::size_t>(shards))
    part.push_back(cells[i]);
  return part;
}

}  // namespace timestep::study
