#include "tests/truth/pair_kinds.hpp"

#include <algorithm>
#include <cmath>

#include "common/physics/epa.hpp"
#include "tests/truth/geom_pairs.hpp"

namespace timestep::truth {
namespace {

using chapter_04::PlacedPair;
using chapter_04::PlacedShape;

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// How far a shape reaches along a direction, from its own position
double reach_along(const PlacedShape& placed, const Vec3& n) {
  const Convex body = convex(placed.shape);
  std::uint32_t hint = 0;
  const Vec3 far =
      body.core_support(body.shape, direction_in_body(placed.pose, n), hint);
  return glm::dot(n, direction_in_world(placed.pose, far)) + body.radius;
}

double reach_of(const PlacedShape& placed) {
  const Convex body = convex(placed.shape);
  return body.reach + body.radius;
}

// How far a point is outside a shape, or off its plane across the normal
double off_surface(const PlacedShape& placed, const Vec3& point, const Vec3& normal) {
  if (const auto* plane = std::get_if<HalfSpace>(&placed.shape))
    return std::abs(glm::dot(plane->normal, point) - plane->offset);
  const Shape dot = Sphere{0};
  const Separation s =
      separation(convex(dot), {point}, convex(placed.shape), placed.pose);
  const double height = glm::dot(normal, point - placed.pose.position);
  return std::max(s.distance, std::abs(height - reach_along(placed, normal)));
}

// How far R is from any rotation, times what it turns
double skew_of(const Json& shape, const PlacedShape& placed) {
  if (!shape.contains("R")) return 0;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum +=
            shape["R"][3 * i + k].get<double>() * shape["R"][3 * j + k].get<double>();
      most = std::max(most, std::abs(sum));
    }
  return most * reach_of(placed);
}

// Coordinates of the position each move by u of the largest. A point of the shape moves
// by u of its distance from there as sizes are rounded, and by twice that as the four
// numbers of its turn are
double moved(const PlacedShape& placed, double u) {
  return u * (std::sqrt(3) * largest(placed.pose.position) + 3 * reach_of(placed));
}

}  // namespace

double gap_along(const std::string& kind, const Json& inputs,
                 const glm::dvec3& direction) {
  const PlacedPair pair = pair_of(kind, inputs);
  const Vec3 n = glm::normalize(direction);
  const double reach_a = reach_along(pair.a, n);
  if (const auto* plane = std::get_if<HalfSpace>(&pair.b.shape)) {
    const bool is_its_own = glm::distance(n, -plane->normal) < 1e-6;
    return is_its_own
               ? glm::dot(plane->normal, pair.a.pose.position) - reach_a - plane->offset
               : -INFINITY;
  }
  return glm::dot(n, pair.b.pose.position - pair.a.pose.position) - reach_a
         - reach_along(pair.b, -n);
}

double witness_error(const std::string& kind, const Json& inputs,
                     const glm::dvec3& normal, double distance,
                     const Witnesses& witnesses) {
  const PlacedPair pair = pair_of(kind, inputs);
  const auto& [on_a, on_b] = witnesses;
  return std::max({glm::length(on_b - on_a - distance * normal),
                   off_surface(pair.a, on_a, normal),
                   off_surface(pair.b, on_b, -normal)});
}

double displacement(const std::string& kind, const Json& inputs, double u) {
  const auto& [a, b] = pair_of(kind, inputs);
  if (const auto* plane = std::get_if<HalfSpace>(&b.shape)) {
    const double out = glm::length(a.pose.position) + reach_of(a);
    return moved(a, u) + u * (std::abs(plane->offset) + 2 * out);
  }
  double all = moved(a, u) + moved(b, u);
  if (kind == "shape_pair")
    all += skew_of(inputs.at("A"), a) + skew_of(inputs.at("B"), b);
  return all;
}

}  // namespace timestep::truth
