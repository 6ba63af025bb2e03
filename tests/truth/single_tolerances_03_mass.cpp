// What single precision may cost in mass properties. Rounding the inputs moves the
// exact answer, and double tells by how much: from the inputs to the nearest floats.
// What the single run adds are its own roundings.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/truth/kind.hpp"

namespace timestep::truth {
namespace {

Json rounded(const Json& value) {
  if (value.is_number()) return double(float(value.get<double>()));
  Json parts = value;
  if (value.is_structured())
    for (Json& part : parts) part = rounded(part);
  return parts;
}

double largest(const Json& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double most = 0;
  for (const Json& part : value) most = std::max(most, largest(part));
  return most;
}

// |a - b| and what is added to it, in the shape of either
Json distance(const Json& a, const Json& b, double more) {
  if (a.is_number()) return std::abs(a.get<double>() - b.get<double>()) + more;
  Json parts = Json::array();
  for (std::size_t i = 0; i < a.size(); ++i)
    parts.push_back(distance(a[i], b[i], more));
  return parts;
}

// u of the largest number of a field: a formula of chapter 3 rounds at most 10 times, a
// tensor is rounded once and then a turn of its axes, of which there are 9 or less,
// rounds each entry 3 times, at random
constexpr double k_roundings = 16;

Json tolerance(const char* kind, const Json& inputs) {
  const auto kinds = double_precision::truth_kinds_03_mass();
  const auto compute = std::ranges::find(kinds, kind, &Kind::name)->compute;
  const Json exact = compute(inputs), moved = compute(rounded(inputs));
  Json all = Json::object();
  for (const auto& [field, value] : exact.items()) {
    const double most = std::max(largest(value), largest(moved[field]));
    const bool held = most <= std::numeric_limits<float>::max()
                      && (most == 0 || most >= std::numeric_limits<float>::min());
    if (!held) throw NotCovered(field + " leaves the range of a float");
    all[field] = distance(value, moved[field], k_roundings * 0x1p-24 * most);
  }
  return all;
}

Json inertia_primitive(const Json& inputs) {
  return tolerance("inertia_primitive", inputs);
}

Json mesh_mass_properties(const Json& inputs) {
  return tolerance("mesh_mass_properties", inputs);
}

}  // namespace

std::span<const Kind> single_tolerances_03_mass() {
  static constexpr std::array<Kind, 2> all{{
      {"inertia_primitive", inertia_primitive},
      {"mesh_mass_properties", mesh_mass_properties},
  }};
  return all;
}

}  // namespace timestep::truth
