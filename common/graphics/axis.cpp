#include "common/graphics/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace timestep {
namespace {

constexpr double k_most_decades = 18;

/// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * 0.999) return factor * power;
  }
  return 10 * power;
}

/// With a real minus sign.
std::string number(double value) {
  std::string text = fmt::format("{:.6g}", value);
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

std::string power_of_ten(int exponent) {
  if (exponent >= 0 && exponent <= 3)
    return fmt::format("{:g}", std::pow(10, exponent));
  static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                  "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += digits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

std::vector<Tick> decade_ticks(const Axis& axis, int count) {
  const int first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
  const int stride = std::max(1, (last - first + count - 1) / count);
  std::vector<Tick> marks;
  for (int e = last; e >= first; e -= stride) {
    marks.push_back({std::pow(10, e), power_of_ten(e)});
  }
  return marks;
}

}  // namespace

double Axis::share(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

Axis axis_for(const std::vector<double>& values, bool logarithmic) {
  Axis axis{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
            logarithmic};
  for (const double v : values) {
    if (!std::isfinite(v) || (logarithmic && v < 1e-290)) continue;
    axis.low = std::min(axis.low, v);
    axis.high = std::max(axis.high, v);
  }
  if (axis.low > axis.high) return {logarithmic ? 0.1 : 0, 1, logarithmic};

  // Whole decades, or a little room above and below
  if (logarithmic) {
    const double top = std::ceil(std::log10(axis.high) - 0.05);
    const double bottom = std::floor(std::log10(axis.low) + 0.05);
    const double lowest = std::max(bottom, top - k_most_decades);
    return {std::pow(10, std::min(lowest, top - 1)), std::pow(10, std::min(top, 308.0)),
            true};
  }
  const double span = axis.high / 2 - axis.low / 2;
  const double least = 1e-12 * std::max(std::abs(axis.low), std::abs(axis.high));
  const double room = span > least ? 0.08 * span : std::max(least, 1e-12) * 10;
  const double limit = std::numeric_limits<double>::max() / 4;
  return {std::max(axis.low - room, -limit), std::min(axis.high + room, limit), false};
}

std::vector<Tick> ticks(const Axis& axis, int count) {
  if (axis.logarithmic) return decade_ticks(axis, count);
  const double step = round_step((axis.high - axis.low) / count);
  std::vector<Tick> marks;
  for (double k = std::ceil(axis.low / step); k * step <= axis.high; ++k) {
    // Away from zero by rounding alone is zero
    marks.push_back({k * step, number(k == 0 ? 0 : k * step)});
    if (marks.size() > 20) break;
  }
  return marks;
}

}  // namespace timestep
