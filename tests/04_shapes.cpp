// Chapter 4's shapes: support functions, bounds and volumes, and the pairs with a
// closed form. Compiled for each precision; u (k_u) is the unit round-off of the one at
// hand.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/physics/epa.hpp"
#include "common/physics/primitives.hpp"
#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

constexpr Real k_infinity = std::numeric_limits<Real>::infinity();
constexpr double k_pi = std::numbers::pi;

Vec3 support_of(const Shape& shape, const Vec3& direction) {
  const Convex body = convex(shape);
  std::uint32_t vertex = 0;
  return body.core_support(body.shape, direction, vertex);
}

// Of the whole shape along a unit direction, not of the core alone
double height(const Shape& shape, const Vec3& direction) {
  return double(glm::dot(direction, support_of(shape, direction)))
         + double(convex(shape).radius);
}

// A point of the shape, any of them
Vec3 point_in(const Shape& shape, Random& random) {
  Vec3 sum(0);
  for (int i = 0; i < 4; ++i) {
    const Vec3 d = random.direction();
    sum += support_of(shape, d) + Real(random.between(0, 1)) * convex(shape).radius * d;
  }
  return sum / Real(4);
}

bool same(const Vec3& a, const Vec3& b) {
  return a == b;
}

}  // namespace

TEST_CASE("no point of a shape is beyond its support point") {
  Random random(4);
  std::vector<Vec3> points;
  for (int kind = 0; kind < k_shape_kinds; ++kind) {
    INFO(k_shape_names[std::size_t(kind)]);
    for (int i = 0; i < 300; ++i) {
      const Shape shape =
          random_shape(random, kind, random.log_between(1e-3, 1e3), points);
      const Vec3 d = random.direction();
      const double rounding =
          8 * k_u * double(convex(shape).reach + convex(shape).radius);
      REQUIRE(glm::dot(d, point_in(shape, random)) <= height(shape, d) + rounding);

      // However long the direction is
      for (const Real length : {Real(1e-30), Real(1e30)})
        REQUIRE(glm::dot(d, support_of(shape, length * d))
                >= glm::dot(d, support_of(shape, d)) - Real(rounding));
      REQUIRE(std::isfinite(glm::dot(d, support_of(shape, Vec3(0)))));
    }
  }
}

TEST_CASE("a support function decides ties as it says") {
  CHECK(same(support(Box{{1, 2, 3}}, {0, 0, -1}), {1, 2, -3}));
  CHECK(same(support(Capsule{1, 2}, {0, 0, 0}), {0, 0, 1}));
  CHECK(same(support(Cylinder{1, 2}, {0, 0, 1}), {0, 0, 1}));
  CHECK(same(support(Cylinder{1, 2}, {1, 0, 0}), {1, 0, 1}));
  CHECK(same(support(Cone{1, 2}, {0, 0, -1}), {0, 0, 0}));
  CHECK(same(support(Cone{2, 2}, {1, 0, 1}), {0, 0, 2}));
  const std::array<Vec3, 3> corners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  CHECK(support_vertex(hull_shape(corners), {1, 0, 0}, 0) == 1);
}

TEST_CASE("a cylinder's support point keeps its digits next to the axis") {
  // Where the direction is 1e-9 off the axis, sqrt(1 - z^2) is 0 or wrong by percents
  const Vec3 p = support(Cylinder{1, 2}, {Real(3e-9), Real(4e-9), 1});
  CHECK(double(p.x) == Approx(0.6).margin(4 * k_u));
  CHECK(double(p.y) == Approx(0.8).margin(4 * k_u));
}

TEST_CASE("a large hull's support is found by climbing, wherever it starts") {
  Random random(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.push_back(random.direction());
  const ConvexHull hull = convex_hull(points).hull;
  const HullShape climbed = hull_shape(hull);
  const HullShape looked_through = hull_shape(std::span<const Vec3>(hull.vertices));
  REQUIRE(!climbed.neighbours.empty());
  for (int i = 0; i < 1000; ++i) {
    const Vec3 d = random.direction();
    const auto start = std::uint32_t(random.bits() % hull.vertices.size());
    const auto found = support_vertex(climbed, d, start);
    const auto best = support_vertex(looked_through, d, 0);
    REQUIRE(glm::dot(hull.vertices[found], d)
            >= glm::dot(hull.vertices[best], d) - Real(4 * k_u));
  }
  CHECK(support_vertex(climbed, {1, 0, 0}, 1u << 30) < hull.vertices.size());
}

TEST_CASE("bounds are as tight as rounding lets them be") {
  Random random(5);
  std::vector<Vec3> points;
  for (int kind = 0; kind < k_shape_kinds; ++kind) {
    INFO(k_shape_names[std::size_t(kind)]);
    const Shape shape = random_shape(random, kind, 2, points);
    const Pose pose{random.in_cube(5), random.turn()};
    const Bounds box = bounds(shape, pose);
    const Real rounding = Real(64 * k_u);
    Vec3 low(k_infinity), high(-k_infinity);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 p = point_in_world(pose, point_in(shape, random));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(box.low[axis] <= low[axis] + rounding);
      CHECK(box.high[axis] >= high[axis] - rounding);

      // Something of the shape is in each of its sides
      Vec3 up(0);
      up[axis] = 1;
      const Vec3 d = direction_in_body(pose, up);
      CHECK(double(box.high[axis])
            == Approx(double(pose.position[axis]) + height(shape, d)).margin(rounding));
    }
  }
  CHECK(bounds(HalfSpace{{0, 0, 1}, 0}, {}).low.x == -k_infinity);
}

TEST_CASE("volumes are those of the formulas") {
  const double some = 16 * k_u;
  CHECK(volume(Sphere{2}) == Approx(4 * k_pi * 8 / 3).epsilon(some));
  CHECK(volume(Box{{1, 2, 3}}) == Approx(48).epsilon(some));
  CHECK(volume(Ellipsoid{{1, 2, 3}}) == Approx(8 * k_pi).epsilon(some));
  CHECK(volume(Capsule{1, 3}) == Approx(k_pi * (3 + 4.0 / 3)).epsilon(some));
  CHECK(volume(Cylinder{2, 3}) == Approx(12 * k_pi).epsilon(some));
  CHECK(volume(Cone{2, 3}) == Approx(4 * k_pi).epsilon(some));
  CHECK(volume(HalfSpace{{0, 0, 1}, 0}) == k_infinity);
  CHECK(volume(HullShape{.vertices = {}, .volume = 7}) == 7);
}

TEST_CASE("spheres that coincide part along z") {
  const Separation s = sphere_sphere(Sphere{1}, {}, Sphere{2}, {});
  CHECK(s.distance == -3);
  CHECK(same(s.normal, {0, 0, 1}));
  CHECK(same(s.on_a, {0, 0, 1}));
  CHECK(same(s.on_b, {0, 0, -2}));

  // And centres 1e-30 m apart along the line between them, not along z
  const Separation near =
      sphere_sphere(Sphere{1}, {}, Sphere{1}, {{Real(1e-30), 0, 0}});
  CHECK(same(near.normal, {1, 0, 0}));
}

TEST_CASE("a sphere's centre in a box goes out through the nearest face") {
  const Box box{{1, 2, 3}};
  const Separation middle = sphere_box(Sphere{1}, {}, box, {});
  CHECK(middle.distance == -2);
  CHECK(same(middle.normal, {-1, 0, 0}));
  const Separation tie = sphere_box(Sphere{1}, {}, Box{{2, 2, 2}}, {});
  CHECK(same(tie.normal, {-1, 0, 0}));
  const Separation low = sphere_box(Sphere{1}, {{0, 0, Real(-2.5)}}, box, {});
  CHECK(low.distance == Real(-1.5));
  CHECK(same(low.normal, {0, 0, 1}));
  CHECK(same(low.on_b, {0, 0, -3}));

  // On the face itself, and off a corner
  CHECK(sphere_box(Sphere{1}, {{1, 0, 0}}, box, {}).distance == -1);
  const Separation corner = sphere_box(Sphere{1}, {{4, 6, 3}}, box, {});
  CHECK(corner.distance == 4);
  CHECK(same(corner.on_b, {1, 2, 3}));
}

TEST_CASE("capsules that cross part along their common perpendicular") {
  const Quat along_x(glm::normalize(glm::dquat(1, 0, 1, 0)));
  const Capsule capsule{Real(0.25), 2};
  const Separation crossing = capsule_capsule(capsule, {}, capsule, {Vec3(0), along_x});
  CHECK(double(crossing.distance) == Approx(-0.5).margin(8 * k_u));
  CHECK(std::abs(double(crossing.normal.y)) == Approx(1).margin(8 * k_u));

  // Nearly parallel, and 1e-12 of their length apart: the direction comes of the axes
  const Pose tilted{{Real(1e-12), 0, 0},
                    Quat(glm::normalize(glm::dquat(1, 1e-4, 0, 0)))};
  const Separation near = capsule_capsule(capsule, {}, capsule, tilted);
  CHECK(std::abs(double(near.normal.x)) == Approx(1).margin(8 * k_u));

  // Side by side, end to end, and on one line
  CHECK(double(capsule_capsule(capsule, {}, capsule, {{1, 0, Real(0.5)}}).distance)
        == Approx(0.5).margin(8 * k_u));
  CHECK(double(capsule_capsule(capsule, {}, capsule, {{0, 0, 3}}).distance)
        == Approx(0.5).margin(8 * k_u));
  const Separation inside = capsule_capsule(capsule, {}, capsule, {{0, 0, Real(0.5)}});
  CHECK(inside.distance == Real(-0.5));
  CHECK(inside.normal.z == 0);
}

TEST_CASE("a half-space answers by the lowest point, another one without end") {
  const HalfSpace ground{{0, 1, 0}, Real(0.25)};
  const Separation s = any_half_space(Box{{1, 2, 3}}, {{5, 4, 0}}, ground, {});
  CHECK(s.distance == Real(1.75));
  CHECK(same(s.normal, {0, -1, 0}));
  CHECK(s.on_b.y == Real(0.25));
  const auto turned = closed_form(ground, {}, Sphere{1}, {{0, 1, 0}});
  REQUIRE(turned.has_value());
  CHECK(turned->distance == Real(-0.25));
  CHECK(same(turned->normal, {0, 1, 0}));
  const Separation both = any_half_space(ground, {}, ground, {});
  CHECK(both.distance == -k_infinity);
  CHECK(both.reason == Reason::unbounded);
}

TEST_CASE("closed forms of numbers that are too large say so") {
  constexpr Real huge = std::numeric_limits<Real>::max();
  constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();
  const Pose left{{-huge, 0, 0}}, right{{huge, 0, 0}}, nowhere{{k_nan, 0, 0}};
  const Shape sphere = Sphere{1}, box = Box{{1, 1, 1}}, capsule = Capsule{1, 1};
  const Shape cylinder = Cylinder{1, 1}, ground = HalfSpace{{1, 0, 0}, 0};
  for (const Shape& other : {sphere, box, capsule, cylinder, ground}) {
    CHECK(closed_form(sphere, left, other, right)->reason == Reason::out_of_range);
    CHECK(closed_form(sphere, nowhere, other, {})->reason == Reason::out_of_range);
  }
  CHECK(closed_form(capsule, left, capsule, right)->reason == Reason::out_of_range);
}

TEST_CASE("closed forms and GJK with EPA are of one opinion") {
  Random random(11);
  std::array<std::vector<Vec3>, 2> points;
  int compared = 0, meeting = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size_a = random.log_between(1e-2, 1e2);
    const double size_b = random.log_between(1e-2, 1e2);
    const Shape a = random_shape(random, i % 5, size_a, points[0]);
    const Shape b = random_shape(random, i / 5 % 5, size_b, points[1]);
    const double apart = random.between(0, 2) * (size_a + size_b);
    const Pose pose_a{Vec3(0), random.turn()};
    const Pose pose_b{Real(apart) * random.direction(), random.turn()};
    const auto closed = closed_form(a, pose_a, b, pose_b);
    if (!closed) continue;

    // A sphere in the middle of a cylinder has nearly the same depth all around, which
    // uses up EPA's vertices
    const Separation s = separation(convex(a), pose_a, convex(b), pose_b);
    const double size = size_a + size_b + apart;
    const double within = s.reason == Reason::iteration_limit
                              ? 1e-3 * size
                              : 2 * double(s.error + closed->error);
    INFO(i << " " << a.index() << " " << b.index() << " " << name_of(s.reason));
    REQUIRE(double(s.distance) == Approx(double(closed->distance)).margin(within));
    ++compared;
    meeting += closed->distance < 0;
  }
  CHECK(compared > 1000);
  CHECK(meeting > 300);
}
