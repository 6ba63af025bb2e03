#include "study/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::study {
namespace {

/// A unit that may be typed for one that a metric has, and how much of that it is.
struct TypedUnit {
  std::string_view of, name;
  double size;
  bool is_shown = false;  ///< answers use it
};

// Of each kind from the smallest to the largest
constexpr double k_degree = 3.14159265358979323846 / 180;
constexpr std::array<TypedUnit, 30> k_units{{
    {"m", "nm", 1e-9, true},
    {"m", "um", 1e-6, true},
    {"m", "mm", 1e-3, true},
    {"m", "cm", 1e-2},
    {"m", "m", 1, true},
    {"rad", "urad", 1e-6, true},
    {"rad", "mrad", 1e-3, true},
    {"rad", "deg", k_degree},
    {"rad", "rad", 1, true},
    {"m/s", "um/s", 1e-6, true},
    {"m/s", "mm/s", 1e-3, true},
    {"m/s", "cm/s", 1e-2},
    {"m/s", "m/s", 1, true},
    {"rad/s", "mrad/s", 1e-3, true},
    {"rad/s", "deg/s", k_degree},
    {"rad/s", "rad/s", 1, true},
    {"s", "ns", 1e-9, true},
    {"s", "us", 1e-6, true},
    {"s", "ms", 1e-3, true},
    {"s", "s", 1, true},
    {"J", "uJ", 1e-6, true},
    {"J", "mJ", 1e-3, true},
    {"J", "J", 1, true},
    {"us", "ns", 1e-3, true},
    {"us", "us", 1, true},
    {"us", "ms", 1e3, true},
    {"us", "s", 1e6, true},
    {"sizes", "%", 1e-2},
    {"", "ppm", 1e-6},
    {"", "%", 1e-2},
}};

std::vector<TypedUnit> units_of(std::string_view unit) {
  std::vector<TypedUnit> all;
  for (const TypedUnit& each : k_units)
    if (each.of == unit) all.push_back(each);
  const bool is_there = std::ranges::count(all, unit, &TypedUnit::name) > 0;
  if (!is_there && !unit.empty()) all.push_back({unit, unit, 1});
  return all;
}

// Without the spaces at its end
std::string_view trimmed(std::string_view text) {
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

// "nm, um, mm, cm or m", or what a number without a unit is
std::string names(const std::vector<TypedUnit>& units) {
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (i > 0) text += i + 1 == units.size() ? " or " : ", ";
    text += units[i].name;
  }
  return text;
}

// The longest unit that fits wins: `1mm` is no number of metres
std::optional<double> parse(std::string_view text,
                            const std::vector<TypedUnit>& units) {
  const TypedUnit* unit = nullptr;
  for (const TypedUnit& each : units)
    if (text.ends_with(each.name)
        && (unit == nullptr || each.name.size() > unit->name.size()))
      unit = &each;
  if (unit == nullptr) return parse_number(trimmed(text));
  text.remove_suffix(unit->name.size());
  const std::optional<double> number = parse_number(trimmed(text));
  if (!number) return std::nullopt;
  return *number * unit->size;
}

}  // namespace

double parse_quantity(std::string_view option, std::string_view text,
                      std::string_view unit) {
  const std::vector<TypedUnit> units = units_of(unit);
  const std::optional<double> value = parse(text, units);
  if (value && *value > 0 && std::isfinite(*value)) return *value;
  throw InputError(
      fmt::format("{} {}: must be a positive number, in {}", option, text,
                  unit.empty() ? "%, ppm or without a unit" : names(units)));
}

std::string quantity_text(double value, std::string_view unit) {
  TypedUnit best{unit, unit, 1};
  for (const TypedUnit& each : k_units)
    if (each.of == unit && each.is_shown && each.size <= std::abs(value)) best = each;
  const std::string number = short_text(value / best.size);
  return unit.empty() ? number : fmt::format("{} {}", number, best.name);
}

}  // namespace timestep::study
