// The kinds of chapter 4: pairs of shapes, answered by every way that takes them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include "chapters/04-contacts/pair_answer.hpp"
#include "common/physics/primitives.hpp"
#include "tests/truth/geom_pairs.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/pair_kinds.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using chapter_04::PlacedPair;
using truth::Json;
using truth::Kind;

constexpr bool k_single = std::is_same_v<Real, float>;
constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;

// Whose answers are judged; libccd's are not ours
constexpr std::array k_others{"closed_form", "sat"};

double distance_of(const PlacedPair& pair) {
  const auto& [a, b] = pair;
  return double(closed_form(a.shape, a.pose, b.shape, b.pose).value().distance);
}

// Distances beside that of the shapes
void add_distances(const std::string& kind, const Json& inputs, Json& computed) {
  PlacedPair pair = pair_of(kind, inputs);
  if (kind == "geom_plane") {
    pair.a.pose.position = Vec3(truth::vector(inputs, "center"));
    pair.a.shape = Sphere{0};
    computed["center_height"] = distance_of(pair);
  }
  if (kind == "geom_capsule_capsule") {
    std::get<Capsule>(pair.a.shape).radius = 0;
    std::get<Capsule>(pair.b.shape).radius = 0;
    computed["axis_distance"] = distance_of(pair);
  }
}

// Beyond what rounding the points may cost
double witness_error(const std::string& kind, const Json& inputs, const Json& answer) {
  const double error = truth::witness_error(
      kind, inputs, truth::vector(answer, "normal"),
      truth::number(answer, "signed_distance"),
      {truth::vector(answer, "witness_A"), truth::vector(answer, "witness_B")});
  return std::max(0.0, error - 4 * truth::displacement(kind, inputs, k_u));
}

// What GJK and EPA answer, and the signed distance by every other way that has one;
// each with how far apart the shapes are along its normal, which is what that is worth
template <std::size_t kind_index>
Json compute(const Json& inputs) {
  const std::string kind(truth::k_pair_kinds[kind_index]);
  const PlacedPair pair = pair_of(kind, inputs);
  Json computed = Json::object();
  for (const PairMethod& method : pair_methods()) {
    const bool is_main = method.name == "gjk_epa";
    const bool is_other = std::ranges::count(k_others, method.name) > 0;
    if (!is_main && !(is_other && method.takes(pair.a.shape, pair.b.shape))) continue;
    Json answer = chapter_04::answer_to(pair, method);
    if (answer["normal"].is_null() || answer["reason"] == "lower_bound") continue;

    const glm::dvec3 normal = truth::vector(answer, "normal");
    const double gap = truth::gap_along(kind, inputs, normal);
    if (is_main) {
      computed = answer;
      computed["witness_error"] = witness_error(kind, inputs, answer);
    }
    const std::string by = is_main ? "" : "_by_" + std::string(method.name);
    computed["signed_distance" + by] = answer["signed_distance"];
    computed["gap_along_normal" + by] = gap;
  }
  add_distances(kind, inputs, computed);
  return computed;
}

// The case as it can be judged: a normal by the gap along it, never by comparing
// vectors, since several may be right; witness points by themselves, since rounding
// alone may make one pair of several the only one; the state where the tolerance leaves
// no doubt. The tolerance is the file's, if it has one, and in single what rounding the
// inputs and the query itself may cost
Json restate(const Json& test, const Json& computed) {
  const std::string kind = test.at("kind");
  const Json& given = test.at("expected");
  const double distance =
      given.contains("signed_distance")
          ? truth::number(given, "signed_distance")
          : std::sqrt(truth::not_negative(given, "signed_distance_squared"));
  Json tol = test.value("tol", Json{{"rel", 0.0}, {"abs", 0.0}});
  if (k_single || !test.contains("tol"))
    tol["abs"] = tol.at("abs").get<double>() + computed.value("error", 0.0)
                 + truth::displacement(kind, test.at("inputs"), k_u);
  const double within =
      tol.at("abs").get<double>() + tol.at("rel").get<double>() * std::abs(distance);

  Json expected{{"signed_distance", distance},
                {"gap_along_normal", distance},
                {"witness_error", 0.0}};
  for (const auto& [name, value] : computed.items())
    if (name.starts_with("signed_distance_by")
        || name.starts_with("gap_along_normal_by"))
      expected[name] = distance;
  const bool is_clear = std::abs(distance) > within;
  if (given.contains("state") && (is_clear || !k_single))
    expected["state"] = given["state"];
  else if (is_clear)
    expected["state"] = distance > 0 ? "separated" : "penetrating";
  for (const char* name : {"center_height", "axis_distance"})
    if (given.contains(name)) expected[name] = given[name];
  return {{"expected", expected}, {"tol", tol}};
}

template <std::size_t... indices>
constexpr auto all_kinds(std::index_sequence<indices...>) {
  return std::array{Kind{truth::k_pair_kinds[indices], compute<indices>, restate}...};
}

}  // namespace

std::span<const Kind> truth_kinds_04() {
  static constexpr auto kinds =
      all_kinds(std::make_index_sequence<truth::k_pair_kinds.size()>());
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
