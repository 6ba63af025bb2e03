/// @file
/// A chart's axis: its range, and round numbers to mark on it.
#pragma once

#include <string>
#include <vector>

namespace timestep {

struct Tick {
  double value;
  std::string text;
};

/// A range with low < high, linear or logarithmic (then low > 0).
struct Axis {
  double low = 0, high = 1;
  bool logarithmic = false;

  /// Where a value lies: 0 at low, 1 at high. Not finite if it has no place.
  double share(double value) const;
};

/// The axis that shows all these values: those that are finite, and positive for a
/// logarithmic one. It spans at most 18 decades, the largest values' ones.
Axis axis_for(const std::vector<double>& values, bool logarithmic);

/// Round values within the range, about `count` of them.
std::vector<Tick> ticks(const Axis& axis, int count);

}  // namespace timestep
