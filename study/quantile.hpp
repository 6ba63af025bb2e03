/// @file
/// Medians and quartiles of measured times.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace timestep::study {

/// The value below which a share of the values lies; interpolated.
inline double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

}  // namespace timestep::study
