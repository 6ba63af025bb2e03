// Triangles with a known answer in each of their seven regions, then thin ones, against
// a search in extended precision: the distance is convex along a side and across it.
#include "chapters/04-contacts/exercises/4_5_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

using Wide = long double;
using WideVec3 = glm::vec<3, Wide>;

Wide distance_to_segment(const WideVec3& p, const WideVec3& a, const WideVec3& b) {
  const WideVec3 e = b - a;
  const Wide ee = glm::dot(e, e);
  const Wide s = ee > 0 ? std::clamp(glm::dot(e, p - a) / ee, Wide(0), Wide(1)) : 0;
  return glm::distance(p, a + s * e);
}

// The least distance to a segment from a to a point of the side from b to c, by golden
// section: 80 times a factor of 0.62 is 2e-17 of the side
double exact_distance(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const WideVec3 p(point), wide_a(a), wide_b(b), side = WideVec3(c) - wide_b;
  const auto distance_at = [&](Wide s) {
    return distance_to_segment(p, wide_a, wide_b + s * side);
  };
  const Wide golden = (std::sqrt(Wide(5)) - 1) / 2;
  Wide low = 0, high = 1;
  for (int i = 0; i < 80; ++i) {
    const Wide left = high - golden * (high - low), right = low + golden * (high - low);
    (distance_at(left) < distance_at(right) ? high : low) =
        distance_at(left) < distance_at(right) ? right : left;
  }
  return double(std::min({distance_at(low), distance_at(0), distance_at(1)}));
}

void expect_distance(const std::string& what, const Vec3& p, const Vec3& a,
                     const Vec3& b, const Vec3& c) {
  const Vec3 yours = closest_on_triangle(p, a, b, c);
  if (!std::isfinite(yours.x + yours.y + yours.z)) FAIL("not finite: " + what);
  double largest = 0;
  for (const Vec3& v : {p, a, b, c})
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const double rounding = 32 * k_u * largest;
  expect("distance [m], " + what, glm::distance(yours, p), exact_distance(p, a, b, c),
         rounding);
  expect("distance [m] from the triangle of your point, " + what,
         exact_distance(yours, a, b, c), 0, rounding);
}

}  // namespace

TEST_CASE("a point above the face") {
  expect("closest point",
         closest_on_triangle({1, 1, 5}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}), {1, 1, 0},
         8 * k_u);
}

TEST_CASE("points beside edges and corners") {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  expect("beside an edge", closest_on_triangle({1, -2, 1}, a, b, c), {1, 0, 0},
         8 * k_u);
  expect("beside the slanted edge", closest_on_triangle({4, 4, 2}, a, b, c), {2, 2, 0},
         8 * k_u);
  expect("beyond a corner", closest_on_triangle({6, -1, 1}, a, b, c), {4, 0, 0},
         8 * k_u);
  expect("beyond the first corner", closest_on_triangle({-1, -1, 1}, a, b, c),
         {0, 0, 0}, 8 * k_u);
}

TEST_CASE("an obtuse corner, where two edges claim the point") {
  expect_distance("obtuse triangle", {1, -0.5, 0}, {0, 0, 0}, {4, 0, 0}, {-3, 1, 0});
  expect_distance("obtuse triangle", {-2, -0.5, 0.3}, {0, 0, 0}, {4, 0, 0}, {-3, 1, 0});
}

TEST_CASE("any triangle") {
  Random random(5);
  for (int i = 0; i < 2000; ++i)
    expect_distance(fmt::format("triangle {}", i), 2.0 * random.in_cube(),
                    random.in_cube(), random.in_cube(), random.in_cube());
}

TEST_CASE("slivers, down to segments and points") {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = random.in_cube(), b = i % 20 == 0 ? a : random.in_cube();
    const double height = i % 10 == 0 ? 0 : random.log_between(1e-18, 1e-2);
    const Vec3 c =
        a + random.between(-0.5, 1.5) * (b - a) + height * random.direction();
    expect_distance(fmt::format("sliver {}, {:.1e} m high", i, height),
                    2.0 * random.in_cube(), a, b, c);
  }
}
