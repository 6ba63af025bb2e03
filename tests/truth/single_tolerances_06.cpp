// What single precision may cost in the kinds of chapters 5 and 6. Each operation in
// single precision answers for numbers that are off by a rounding, so the whole answers
// for inputs that are off by some roundings each: double tells what a rounding of each
// input does, and all of that is added up.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/truth/kind.hpp"

namespace timestep::truth {
namespace {

constexpr double k_u = 0x1p-24;

double largest(const Json& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double most = 0;
  if (value.is_structured())
    for (const Json& part : value) most = std::max(most, largest(part));
  return most;
}

// |a - b|, in the shape of either; 0 of words
Json distance(const Json& a, const Json& b) {
  if (a.is_number()) return std::abs(a.get<double>() - b.get<double>());
  if (!a.is_array()) return 0.0;
  Json parts = Json::array();
  for (std::size_t i = 0; i < a.size(); ++i) parts.push_back(distance(a[i], b[i]));
  return parts;
}

void add(Json& sum, const Json& more, double factor) {
  if (sum.is_number())
    sum = sum.get<double>() + factor * more.get<double>();
  else
    for (std::size_t i = 0; i < sum.size(); ++i) add(sum[i], more[i], factor);
}

void add_constant(Json& sum, double more) {
  if (sum.is_number())
    sum = sum.get<double>() + more;
  else
    for (Json& part : sum) add_constant(part, more);
}

// Calls `change` for each number of a tree with the size of the list that it is in
void for_each_number(Json& tree, double size, const auto& change) {
  if (tree.is_number_float()) change(tree, std::max(size, largest(tree)));
  if (!tree.is_structured()) return;
  const double of_list = tree.is_array() ? largest(tree) : 0;
  for (Json& part : tree) for_each_number(part, of_list, change);
}

// So many roundings of each input and of the field itself
Json tolerance(const char* kind, const Json& inputs, double roundings) {
  const auto kinds = double_precision::truth_kinds_06();
  const auto compute = std::ranges::find(kinds, kind, &Kind::name)->compute;
  const Json exact = compute(inputs);
  Json all = Json::object();
  for (const auto& [field, value] : exact.items()) {
    all[field] = distance(value, value);
    add_constant(all[field], roundings * k_u * largest(value));
  }
  Json moved = inputs;
  for_each_number(moved, 0, [&](Json& number, double size) {
    const Json before = number;
    number = before.get<double>() + k_u * size;
    const Json other = compute(moved);
    number = before;
    for (const auto& [field, value] : exact.items())
      add(all[field], distance(value, other.at(field)), roundings);
  });
  return all;
}

// A step rounds at most four times: the bias, the impulse, the velocity, the place
Json baumgarte_resting(const Json& inputs) {
  Json all = tolerance("baumgarte_resting", inputs, 4);
  const double n = inputs.at("n").get<double>();
  const double depth = std::abs(inputs.at("penetration0").get<double>());
  const double dt = inputs.at("dt").get<double>();
  add_constant(all["penetration"], 4 * n * k_u * depth);
  add_constant(all["velocity"], 4 * n * k_u * depth / dt);
  return all;
}

// No coefficient is the result of more than eight operations
Json soft_contact_coefficients(const Json& inputs) {
  return tolerance("soft_contact_coefficients", inputs, 8);
}

// Sweeps never amplify an error: each update adds its four roundings of the largest
// impulse, and an impulse is the sum of all updates of its row
Json pgs_stack(const Json& inputs) {
  Json all = tolerance("pgs_stack", inputs, 4);
  const double n = inputs.at("n").get<double>();
  const double updates = n * inputs.at("iterations").get<double>();
  double most = 0, least = largest(inputs.at("mass"));
  for (const Json& mass : inputs.at("mass"))
    least = std::min(least, mass.get<double>());
  most = n * largest(inputs.at("mass")) * inputs.at("g").get<double>()
         * inputs.at("dt").get<double>();
  const double error = 4 * updates * k_u * most;
  add_constant(all["impulses"], error);
  add_constant(all["velocities"], 2 * error / least);
  add_constant(all["floor_impulse_relative_error"], 4 * updates * k_u);
  return all;
}

// An inertia tensor in the world, K, its inverse and the new velocities: three or four
// operations each on numbers that are sums of three products
Json two_body_impulse(const Json& inputs) {
  constexpr double k_roundings = 16;
  Json all = tolerance("two_body_impulse", inputs, k_roundings);

  // What is left of the relative velocity is the difference of the bodies' own, and of
  // turns over arms
  double speed = 0, arm = 0;
  for (const char* name : {"A", "B"}) {
    const Json& body = inputs.at(name);
    arm += largest(body.at("position")) + largest(inputs.at("point"));
    speed += largest(body.at("velocity"));
  }
  const auto kinds = double_precision::truth_kinds_06();
  const auto kind = std::ranges::find(kinds, "two_body_impulse", &Kind::name);
  const Json after = kind->compute(inputs);
  for (const char* name : {"vA", "vB"}) speed += largest(after.at(name));
  for (const char* name : {"wA", "wB"}) speed += arm * largest(after.at(name));
  for (const char* name : {"relative_normal_velocity_after", "tangential_speed_after"})
    add_constant(all[name], k_roundings * k_u * speed);
  return all;
}

}  // namespace

std::span<const Kind> single_tolerances_06() {
  static constexpr std::array<Kind, 4> all{{
      {"baumgarte_resting", baumgarte_resting},
      {"soft_contact_coefficients", soft_contact_coefficients},
      {"pgs_stack", pgs_stack},
      {"two_body_impulse", two_body_impulse},
  }};
  return all;
}

}  // namespace timestep::truth
