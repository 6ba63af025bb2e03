/// @file
/// One cell of the study: one run of one method, with everything that it depends on.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "study/problem.hpp"

namespace timestep::study {

/// What is run. `settings` are all parameters that are not at the scene's default.
struct Cell {
  const Problem* problem = nullptr;
  std::string method;
  std::string precision;  ///< "single" or "double"
  double dt = 0;          ///< [s]
  std::map<std::string, double> settings{};
};

/// What identifies a cell in every file: "orbit/rk4/double/dt=0.0625", then every
/// setting that is not the problem's own: "/iterations=10".
std::string key(const Cell& cell);

/// All cells of these problems, in a fixed order: problem, method, precision (double
/// first), dt, axes. If `quick`, every second step and value.
std::vector<Cell> cells(std::span<const Problem* const> problems, bool quick);

/// Those of these names; of none, all, or the quick ones. Throws InputError for an
/// unknown name.
std::vector<const Problem*> studied_problems(std::span<const std::string> names,
                                             bool quick);

/// Those that shard `shard` of `shards` computes, counted from 1: every so manieth one.
std::vector<Cell> shard_of(std::span<const Cell> cells, int shard, int shards);

}  // namespace timestep::study
