#include "common/chapter/numbers.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace timestep {
namespace {

std::optional<double> parse_plain(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return parse_plain(text);

  const auto above = parse_plain(text.substr(0, slash));
  const auto below = parse_plain(text.substr(slash + 1));
  if (!above || !below || !std::isfinite(*above / *below)) return std::nullopt;
  return *above / *below;
}

std::optional<int> parse_integer(std::string_view text, int minimum, int maximum) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  if (value < minimum || value > maximum) return std::nullopt;
  return value;
}

std::string exact_text(double value) {
  if (std::isnan(value)) return "nan";
  return fmt::format("{}", value);
}

std::string plain_text(double value) {
  const std::string text = fmt::format("{:g}", value);
  return parse_number(text) == value ? text : exact_text(value);
}

std::string short_text(double value) {
  return fmt::format("{:.4g}", value);
}

std::string step_text(double dt) {
  const double rate = std::round(1 / dt);
  if (rate >= 2 && rate <= 100000 && 1 / rate == dt && std::fmod(1000, rate) != 0) {
    return fmt::format("1/{:.0f} s", rate);
  }
  return short_text(dt) + " s";
}

}  // namespace timestep
