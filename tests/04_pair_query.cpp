// Chapter 4's ways to answer a pair: all of them are of one opinion, and each says what
// it does not know.
#include <cmath>
#include <string>
#include <vector>

#include "common/physics/convex_hull.hpp"
#include "common/physics/pair_query.hpp"
#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

const PairMethod& method(std::string_view name) {
  for (const PairMethod& m : pair_methods())
    if (m.name == name) return m;
  FAIL("no method " << name);
  return pair_methods()[0];
}

struct Bodies {
  Shape a, b;
  Pose pose_a, pose_b;
  std::vector<Vec3> points_a, points_b;
  ConvexHull hull_a, hull_b;
};

// The cloud's hull, so that the view has faces
void with_faces(Shape& shape, std::span<const Vec3> points, ConvexHull& hull) {
  if (!std::holds_alternative<HullShape>(shape)) return;
  hull = convex_hull(points).hull;
  shape = hull_shape(hull);
}

void make(Random& random, int kind_a, int kind_b, Bodies& p) {
  p.a = random_shape(random, kind_a, 1, p.points_a);
  p.b = random_shape(random, kind_b, random.log_between(0.1, 10), p.points_b);
  with_faces(p.a, p.points_a, p.hull_a);
  with_faces(p.b, p.points_b, p.hull_b);
  p.pose_a = {random.in_cube(3), random.turn()};
  p.pose_b = {p.pose_a.position + random.in_cube(2), random.turn()};
}

}  // namespace

TEST_CASE("every way to ask finds the same of a pair, or says what it does not know") {
  Random random(41);
  int answers = 0, bounds = 0, overlaps = 0, more = 0;
  for (int i = 0; i < 20 * k_shape_kinds * k_shape_kinds; ++i) {
    Bodies p;
    make(random, i % k_shape_kinds, i / k_shape_kinds % k_shape_kinds, p);
    const Separation best = method("gjk_epa").query(p.a, p.pose_a, p.b, p.pose_b);
    const double size = double(glm::distance(p.pose_a.position, p.pose_b.position))
                        + double(convex(p.a).reach + convex(p.b).reach)
                        + double(convex(p.a).radius + convex(p.b).radius);
    for (const PairMethod& m : pair_methods()) {
      const Separation s = m.query(p.a, p.pose_a, p.b, p.pose_b);
      INFO(i << " " << m.name << " " << name_of(s.reason) << " " << double(s.distance)
             << " " << double(best.distance));
      REQUIRE((s.reason == Reason::no_answer) == !m.takes(p.a, p.b));
      if (s.reason == Reason::no_answer) continue;

      // Nothing is NaN, the normal is one, and the witness points are that far apart
      ++answers;
      REQUIRE(double(glm::length(s.normal)) == Approx(1).margin(8 * k_u));
      const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
      REQUIRE(double(glm::length(left)) <= 64 * k_u * (size + 3));

      // Smooth shapes are approximated: ours to 1e-3 of their size, libccd in as many
      // steps as it has
      const bool at_limit =
          s.reason == Reason::iteration_limit || best.reason == Reason::iteration_limit;
      const double within =
          at_limit ? 1e-2 * size : 8 * double(best.error + s.error) + 1e-6 * size;
      if (s.reason == Reason::lower_bound) {
        ++bounds;
        REQUIRE(s.distance > 0);
        REQUIRE(double(s.distance - best.distance) <= within);
        continue;
      }

      // Where they overlap MPR finds a depth that is not always the least
      overlaps += best.distance < 0;
      if (m.name == "libccd_mpr" || m.name == "libccd_epa")
        more += double(s.distance) < double(best.distance) - within;
      else
        REQUIRE(double(s.distance) == Approx(double(best.distance)).margin(within));
    }
  }
  CHECK(answers > 3000);
  CHECK(bounds > 400);
  CHECK(overlaps > 500);
  CHECK(more > 20);
}

TEST_CASE("half-spaces are answered by formula, and by those that know one") {
  const Shape plane = HalfSpace{{0, 0, 1}, 1}, ball = Sphere{2};
  for (const auto* const name : {"gjk_epa", "closed_form"}) {
    const PairMethod& m = method(name);
    REQUIRE(m.takes(plane, ball));
    const Separation above = m.query(plane, {}, ball, {{0, 0, 4}});
    CHECK(above.distance == 1);
    CHECK(above.normal == Vec3(0, 0, 1));
    const Separation below = m.query(ball, {{0, 0, 2}}, plane, {});
    CHECK(below.distance == -1);
    CHECK(below.normal == Vec3(0, 0, -1));
    CHECK(m.query(plane, {}, plane, {}).reason == Reason::unbounded);
  }
  for (const auto* const name : {"sat", "libccd_epa", "libccd_mpr"}) {
    CHECK(!method(name).takes(plane, ball));
    CHECK(method(name).query(plane, {}, ball, {}).reason == Reason::no_answer);
  }
}

TEST_CASE("separating axes take boxes with boxes and hulls that have faces") {
  const PairMethod& sat = method("sat");
  const ConvexHull cube = box_hull({1, 1, 1});
  const Shape box = Box{{1, 1, 1}}, hull = hull_shape(cube);
  const Shape cloud = hull_shape(cube.vertices);
  CHECK(sat.takes(box, box));
  CHECK(sat.takes(hull, hull));
  CHECK(!sat.takes(box, hull));
  CHECK(!sat.takes(hull, cloud));
  CHECK(!sat.takes(box, Sphere{1}));
  const Pose beside{{Real(1.5), 0, 0}};
  CHECK(double(sat.query(box, {}, box, beside).distance) == Approx(-0.5));
  CHECK(double(sat.query(hull, {}, hull, beside).distance) == Approx(-0.5));
}

TEST_CASE("libccd ends, with a number, on pairs without volume and in ties") {
  const std::vector<Vec3> point{Vec3(0)}, line{Vec3(-1, 0, 0), Vec3(1, 0, 0)};
  const std::vector<Vec3> triangle{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0)};
  const std::vector<Shape> shapes{
      hull_shape(point), hull_shape(line), hull_shape(triangle), Sphere{0},
      Sphere{1},         Box{{1, 1, 1}},   Ellipsoid{{1, 1, 1}}, Cylinder{1, 2},
      Cone{1, 1}};
  for (const auto* const name : {"libccd_epa", "libccd_mpr"})
    for (const Shape& a : shapes)
      for (const Shape& b : shapes)
        for (const Real x : {Real(0), Real(1), Real(2), Real(1e-9)}) {
          const Separation s = method(name).query(a, {}, b, {{x, 0, 0}});
          CHECK(std::isfinite(s.distance));
          CHECK(double(glm::length(s.normal)) == Approx(1).margin(8 * k_u));
          CHECK(std::isfinite(glm::dot(s.on_a, s.on_b)));
        }
  const Shape box = Box{{1, 1, 1}};
  constexpr Real k_infinity = std::numeric_limits<Real>::infinity();
  CHECK(method("libccd_mpr").query(box, {}, box, {{k_infinity, 0, 0}}).reason
        == Reason::out_of_range);
}
