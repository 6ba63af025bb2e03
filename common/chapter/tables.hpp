/// @file
/// A run over time as two tables: trajectory.csv and history.csv.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>

#include "common/chapter/runner.hpp"

namespace timestep {

/// Writes both tables as the run goes on, so that a long run needs no memory for them.
///
/// trajectory.csv has a row a sample and body: time, body, x, y, z [m], vx, vy, vz
/// [m/s], and, where any body has them, qw, qx, qy, qz and wx, wy, wz [rad/s]; at most
/// the first 64 bodies of a method. history.csv has a row a sample: time and every
/// metric. Names have their method before them if several run. A method that failed has
/// no rows, or empty cells, from then on.
class Tables {
 public:
  /// Opens both files.
  Tables(const std::filesystem::path& trajectory, const std::filesystem::path& history);

  /// Adds the lanes' latest samples at `time` [s]; the first call adds the headings.
  void add(double time, std::span<const Lane> lanes);

  /// Writes out what is still in memory. Throws InputError if anything could not be.
  void finish();

 private:
  void add_headings(std::span<const Lane> lanes);
  void add_body(double time, const std::string& prefix, const BodyState& body);

  std::ofstream trajectory_, history_;
  bool started_ = false, has_rotation_ = false;
};

}  // namespace timestep
