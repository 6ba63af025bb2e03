#include "tests/truth/inputs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"

namespace timestep::truth {
namespace {

constexpr int k_longest_list = 10000;

long long whole(const Json& value, const char* name, double least, double most) {
  const double n = value.is_number() ? value.get<double>() : -1;
  if (!(n >= least && n <= most) || n != std::floor(n))
    throw InputError(
        fmt::format("{}: must be a whole number from {:g} to {:g}", name, least, most));
  return static_cast<long long>(n);
}

}  // namespace

double number(const Json& inputs, const char* name) {
  const Json& value = inputs.at(name);
  if (!value.is_number()) throw InputError(fmt::format("{}: must be a number", name));
  return value.get<double>();
}

double positive(const Json& inputs, const char* name) {
  const double value = number(inputs, name);
  if (!(value > 0)) throw InputError(fmt::format("{}: must be above 0", name));
  return value;
}

double not_negative(const Json& inputs, const char* name) {
  const double value = number(inputs, name);
  if (!(value >= 0)) throw InputError(fmt::format("{}: must not be below 0", name));
  return value;
}

double between(const Json& inputs, const char* name, double least, double most) {
  const double value = number(inputs, name);
  if (!(value >= least && value <= most))
    throw InputError(fmt::format("{}: must be from {:g} to {:g}", name, least, most));
  return value;
}

int count(const Json& inputs, const char* name) {
  return static_cast<int>(whole(inputs.at(name), name, 1, k_longest_list));
}

std::vector<double> numbers(const Json& inputs, const char* name) {
  const Json& v = inputs.at(name);
  const auto is_number = [](const Json& part) { return part.is_number(); };
  if (!v.is_array() || !std::ranges::all_of(v, is_number) || v.empty()
      || v.size() > k_longest_list)
    throw InputError(
        fmt::format("{}: must be a list of 1 to {} numbers", name, k_longest_list));
  return v.get<std::vector<double>>();
}

std::vector<double> positive_numbers(const Json& inputs, const char* name) {
  std::vector<double> all = numbers(inputs, name);
  if (!(std::ranges::min(all) > 0))
    throw InputError(fmt::format("{}: must be above 0", name));
  return all;
}

glm::dvec3 vector(const Json& inputs, const char* name) {
  const Json& v = inputs.at(name);
  const auto is_number = [](const Json& part) { return part.is_number(); };
  if (!v.is_array() || v.size() != 3 || !std::ranges::all_of(v, is_number))
    throw InputError(fmt::format("{}: must be three numbers", name));
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

long long steps(const Json& inputs) {
  return whole(inputs.at("n"), "n", 0, 1e8);
}

std::vector<long long> ladder(const Json& inputs) {
  const Json& list = inputs.at("steps");
  if (!list.is_array() || list.empty() || list.size() > 32)
    throw InputError("steps: must be a list of 1 to 32 numbers");
  std::vector<long long> all;
  for (const Json& n : list) all.push_back(whole(n, "steps", 1, 1e6));
  return all;
}

}  // namespace timestep::truth
