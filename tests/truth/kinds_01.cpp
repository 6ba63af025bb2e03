// The kinds of chapter 1 that need no other chapter, computed through the code in
// common/physics.
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/euler.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/rounding.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/pair.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::number;
using truth::OtherPrecision;
using truth::Pair;
using truth::positive;
using truth::product;
using truth::steps;
using truth::vector;

Json json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

Json linear_drag_projectile(const Json& inputs) {
  const double m = positive(inputs, "m");
  const double c = number(inputs, "c");
  const glm::dvec3 g = vector(inputs, "g");
  const exact::Motion end = exact::linear_drag(
      {vector(inputs, "x0"), vector(inputs, "v0")}, g, c / m, number(inputs, "t"));
  return {
      {"x", json(end.x)}, {"v", json(end.v)}, {"terminal_velocity", json(m * g / c)}};
}

Json quadratic_drag_fall(const Json& inputs) {
  const double m = positive(inputs, "m");
  const double k = number(inputs, "k");
  const double g = number(inputs, "g");
  const exact::Motion end = exact::quadratic_drag(
      {glm::dvec3(0), glm::dvec3(0)}, {0, -g, 0}, k / m, number(inputs, "t"));
  return {{"fall_distance", -end.x.y},
          {"speed", -end.v.y},
          {"terminal_speed", std::sqrt(m * g / k)}};
}

// Kinds that name their own precision are answered by the library of that precision
// alone.
void only_in(const Json& inputs) {
  const bool single = std::numeric_limits<Real>::digits == 24;
  if ((inputs.at("precision") == "float32") != single)
    throw OtherPrecision("precision");
}

Json time_accumulation(const Json& inputs) {
  only_in(inputs);
  const double dt = number(inputs, "dt");
  const long long n = steps(inputs);
  const double t = accumulated_time(Real(dt), n);
  const Pair ideal = product({dt, 0}, static_cast<double>(n));
  return {{"t", t},
          {"ideal", ideal.high},
          {"relative_error", quotient(difference({t, 0}, ideal), ideal)},
          {"dt_in_precision", Real(dt)}};
}

Json float_spacing(const Json& inputs) {
  only_in(inputs);
  return {{"ulp", spacing(Real(number(inputs, "value")))}};
}

Json free_fall_float32(const Json& inputs) {
  if (std::numeric_limits<Real>::digits != 24) throw OtherPrecision("single only");
  const double y0 = number(inputs, "y0");
  const double g = number(inputs, "g");
  const double dt = number(inputs, "dt");
  const long long n = steps(inputs);
  State state{.x = {Real(y0)}, .v = {0}, .a = {0}};
  const Acceleration gravity = [g](auto, auto, Real, auto a) { a[0] = -Real(g); };
  for (long long i = 0; i < n; ++i) semi_implicit_euler(state, gravity, 0, Real(dt));

  // (1.4) summed up: y0 - g dt² n (n + 1) / 2
  const auto count = static_cast<double>(n);
  const Pair fallen =
      product(product(product({dt, 0}, dt), g), count * (count + 1) / 2);
  const Pair y = difference({y0, 0}, fallen);
  const Pair lost = difference({state.x[0], 0}, y);
  return {{"y_float32", state.x[0]},
          {"y_exact_arithmetic", y.high + y.low},
          {"lost_metres", lost.high + lost.low}};
}

}  // namespace

std::span<const Kind> truth_kinds_01() {
  static constexpr std::array<Kind, 5> kinds{{
      {"linear_drag_projectile", linear_drag_projectile},
      {"quadratic_drag_fall", quadratic_drag_fall},
      {"time_accumulation", time_accumulation},
      {"float_spacing", float_spacing},
      {"free_fall_float32", free_fall_float32},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
