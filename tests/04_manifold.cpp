// Chapter 4's contact manifolds: boxes, hulls, half-spaces and round shapes, at the
// border between apart and overlapping, swapped, and from one frame to the next.
// Compiled for each precision; u (k_u) is the unit round-off of the one at hand.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "common/physics/manifold.hpp"
#include "common/physics/sat.hpp"
#include "tests/catch.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

std::vector<ContactPoint> points_of(const Manifold& m) {
  return {m.points.begin(), m.points.begin() + m.count};
}

std::set<std::uint64_t> features(const Manifold& m) {
  std::set<std::uint64_t> names;
  for (const ContactPoint& p : points_of(m)) names.insert(p.feature);
  return names;
}

double deepest(const Manifold& m) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ContactPoint& p : points_of(m)) most = std::max(most, double(p.depth));
  return most;
}

// Of the quadrangle or triangle that the points make about the normal
double area(const Manifold& m) {
  double most = 0;
  const auto twice = [&](int i, int j, int k) {
    const auto at = [&](int n) { return m.points[std::size_t(n)].position; };
    return std::abs(
        double(glm::dot(m.normal, glm::cross(at(j) - at(i), at(k) - at(i)))));
  };
  if (m.count == 3) return twice(0, 1, 2) / 2;
  if (m.count < 4) return 0;

  // Four points in a convex place: both diagonals cut it in two; the wrong order is
  // less
  most = std::max({twice(0, 1, 2) + twice(0, 2, 3), twice(0, 1, 2) + twice(1, 2, 3),
                   twice(0, 2, 1) + twice(0, 1, 3)});
  return most / 2;
}

// How far a point is from the surface of a hull
double off_surface(const ConvexHull& hull, const Pose& pose, const Vec3& point) {
  const Vec3 p = point_in_body(pose, point);
  double highest = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : hull.planes)
    highest = std::max(highest, double(glm::dot(plane.normal, p) - plane.offset));
  return std::abs(highest);
}

bool has_partner(const Manifold& m, const ContactPoint& point, double tolerance) {
  return std::ranges::any_of(points_of(m), [&](const ContactPoint& p) {
    return glm::distance(p.position, point.position) <= tolerance
           && std::abs(p.depth - point.depth) <= tolerance;
  });
}

Separation separation_of(const auto& a, const Pose& pose_a, const auto& b,
                         const Pose& pose_b) {
  return sat(a, pose_a, b, pose_b).separation;
}

Manifold manifold_of(const auto& a, const Pose& pose_a, const auto& b,
                     const Pose& pose_b, Real margin = 0) {
  return contact_manifold(a, pose_a, b, pose_b, separation_of(a, pose_a, b, pose_b),
                          margin);
}

const Box k_cube{Vec3(Real(0.5))};

Pose above(Real height) {
  return {.position = {0, 0, height}};
}

}  // namespace

TEST_CASE("a box on a box touches in the four corners of what they share") {
  const Pose upper{.position = {Real(0.25), Real(0.125), Real(0.9375)}};
  const Manifold m = manifold_of(k_cube, {}, k_cube, upper);
  REQUIRE(m.count == 4);
  CHECK(m.normal == Vec3(0, 0, 1));
  CHECK(features(m).size() == 4);
  for (const ContactPoint& p : points_of(m)) {
    CHECK(p.depth == Approx(0.0625));
    CHECK(on_a(m, p).z == Approx(0.5));
    CHECK(on_b(m, p).z == Approx(0.4375));
  }
  CHECK(area(m) == Approx(0.75 * 0.875));
}

TEST_CASE("apart, touching, overlapping: the border is at the margin") {
  const Real gap = Real(0.01);
  CHECK(manifold_of(k_cube, {}, k_cube, above(1 + gap)).count == 0);
  CHECK(manifold_of(k_cube, {}, k_cube, above(1 + gap), gap / 2).count == 0);
  const Manifold near = manifold_of(k_cube, {}, k_cube, above(1 + gap), 2 * gap);
  CHECK(near.count == 4);
  CHECK(deepest(near) == Approx(-gap).epsilon(1e-4));

  // Touching up to rounding is touching, in all four corners
  for (const double ulps : {-4.0, -1.0, 0.0, 1.0, 4.0}) {
    const Manifold touching =
        manifold_of(k_cube, {}, k_cube, above(Real(1 + ulps * k_u)));
    CHECK(touching.count == 4);
    CHECK(std::abs(deepest(touching)) <= 16 * k_u);
  }

  // On one edge, the other two corners are apart: two points, or four with a margin
  Pose tilted = above(1);
  tilted.orientation = rotation_by({0, Real(0.02), 0});
  CHECK(manifold_of(k_cube, {}, k_cube, tilted).count == 2);
  CHECK(manifold_of(k_cube, {}, k_cube, tilted, Real(0.03)).count == 4);
}

TEST_CASE("points are on both surfaces, and the deepest is as deep as the shapes are") {
  Random random(1);
  int faces = 0, edges = 0, lone = 0, several = 0;

  // 64 u times the faces' reach; more where rounding turns a side a tenth as long
  constexpr double off = 64 * k_u * 5 / 0.1;
  for (int i = 0; i < 20000; ++i) {
    const ConvexHull a = i % 2 == 0 ? random_hull(random, 5 + i % 20)
                                    : box_hull(Vec3(random.log_between(0.1, 1), 1, 1));
    const ConvexHull b = i % 3 == 0 ? random_hull(random, 5 + i % 20)
                                    : box_hull(Vec3(1, random.log_between(0.1, 1), 1));
    Pose pose_a{random.in_cube(), random.turn()};
    Pose pose_b{pose_a.position + random.direction(), random.turn()};
    if (i % 5 == 0) pose_b.orientation = pose_a.orientation;

    // Into a shallow overlap, as contacts are
    const Separation apart = separation_of(a, pose_a, b, pose_b);
    pose_b.position -=
        (apart.distance + Real(random.log_between(1e-4, 0.1))) * apart.normal;
    const SatResult result = sat(a, pose_a, b, pose_b);
    const Separation& s = result.separation;
    if (s.distance >= 0) continue;
    const Manifold m = contact_manifold(a, pose_a, b, pose_b, s);
    INFO(i);
    REQUIRE(m.count >= 1);
    CHECK(std::abs(deepest(m) + s.distance) <= 1e-2 * std::abs(s.distance) + 256 * k_u);
    for (const ContactPoint& p : points_of(m)) {
      CHECK(p.depth <= -s.distance + off);
      CHECK(p.depth >= -off);
      lone += p.feature == 0 && result.feature != SatFeature::edges;
      if (p.feature == 0) continue;
      CHECK(off_surface(a, pose_a, on_a(m, p)) < off);
      CHECK(off_surface(b, pose_b, on_b(m, p)) < off);
    }
    (result.feature == SatFeature::edges ? edges : faces) += 1;
    several += m.count > 1;
  }
  CHECK(faces > 3000);
  CHECK(edges > 1000);
  CHECK(several > 2000);
  CHECK(lone < 200);
}

TEST_CASE("asked for the other way round, the points are the same") {
  Random random(2);
  int several = 0;
  for (int i = 0; i < 5000; ++i) {
    const Box a{Vec3(random.log_between(0.1, 1), 1, 1)};
    const Box b{Vec3(1, random.log_between(0.1, 1), 1)};
    const Pose pose_a{random.in_cube(), random.turn()};
    Pose pose_b{pose_a.position + random.direction(), random.turn()};
    if (i % 2 == 0)
      pose_b.orientation =
          pose_a.orientation * rotation_by({0, 0, Real(random.between(0, 3))});
    const Separation apart = separation_of(a, pose_a, b, pose_b);
    pose_b.position -= (apart.distance + Real(0.01)) * apart.normal;
    const Separation s = separation_of(a, pose_a, b, pose_b);
    const Manifold m = contact_manifold(a, pose_a, b, pose_b, s);
    const Manifold other = contact_manifold(b, pose_b, a, pose_a, swapped(s));
    INFO(i);
    CHECK(m.normal == -other.normal);
    CHECK(m.count == other.count);
    CHECK(deepest(m) == Approx(deepest(other)).margin(256 * k_u));

    // Of more than four, which ones is a matter of near ties
    if (m.count == 4)
      CHECK(area(m) > 0.7 * area(other) - 256 * k_u);
    else
      for (const ContactPoint& p : points_of(m))
        CHECK(has_partner(other, p, 1024 * k_u));
    several += m.count > 1;
  }
  CHECK(several > 2000);
}

TEST_CASE("features stay as they are while a box slides, turns and presses a little") {
  Random random(3);
  int kept = 0, frames = 0;
  for (int i = 0; i < 200; ++i) {
    const Box a{Vec3(1, 1, Real(0.5))}, b{Vec3(Real(0.5))};
    Pose pose_b{.position = {Real(random.between(-1, 1)), Real(random.between(-1, 1)),
                             Real(0.995)},
                .orientation = rotation_by({0, 0, Real(random.between(0.1, 0.7))})};
    const std::set<std::uint64_t> first = features(manifold_of(a, {}, b, pose_b));
    for (int frame = 0; frame < 20; ++frame) {
      pose_b.position += random.in_cube(1e-5);
      pose_b.orientation =
          glm::normalize(rotation_by(random.in_cube(1e-5)) * pose_b.orientation);
      ++frames;
      kept += features(manifold_of(a, {}, b, pose_b)) == first;
    }
  }
  CHECK(kept > 0.97 * frames);
}

TEST_CASE(
    "of eight corners, the four of the largest area are kept, the deepest among them") {
  Pose pose = above(Real(0.99));
  pose.orientation = rotation_by({0, 0, Real(std::numbers::pi / 4)});
  const Manifold flat = manifold_of(k_cube, {}, k_cube, pose);
  REQUIRE(flat.count == 4);

  // Of a regular octagon about a circle of radius 1/2: the largest quadrangle is a
  // square
  const double corner = 0.5 / std::cos(std::numbers::pi / 8);
  CHECK(area(flat) > 0.95 * 2 * corner * corner);

  pose.orientation = rotation_by({Real(0.001), Real(0.002), 0}) * pose.orientation;
  const Separation s = separation_of(k_cube, {}, k_cube, pose);
  const Manifold tilted = contact_manifold(k_cube, {}, k_cube, pose, s);
  REQUIRE(tilted.count == 4);
  CHECK(deepest(tilted) == Approx(-s.distance).margin(64 * k_u));
  CHECK(area(tilted) > 0.9 * 2 * corner * corner);
}

TEST_CASE("faces with many corners, planes, round shapes") {
  // A prism over 100 corners
  std::vector<Vec3> corners;
  for (int i = 0; i < 100; ++i) {
    const double angle = i * std::numbers::pi / 50;
    for (const double z : {-0.5, 0.5})
      corners.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const ConvexHull prism = convex_hull(corners).hull;
  REQUIRE(prism.planes.size() == 102);
  const ConvexHull slab = box_hull({2, 2, Real(0.5)});
  const Manifold m = manifold_of(slab, {}, prism, above(Real(0.99)));
  REQUIRE(m.count == 4);
  CHECK(area(m) > 1.9);
  for (const ContactPoint& p : points_of(m))
    CHECK(p.depth == Approx(0.01).epsilon(1e-3));

  // A half-space has no sides; a plane that is far below tells no less
  const HalfSpace ground{{0, 0, 1}, 0};
  const Separation down{.distance = Real(-0.01),
                        .normal = {0, 0, 1},
                        .on_a = {0, 0, 0},
                        .on_b = {0, 0, Real(-0.01)}};
  const Manifold standing =
      contact_manifold(ground, {}, k_cube, above(Real(0.49)), down);
  REQUIRE(standing.count == 4);
  CHECK(area(standing) == Approx(1));
  CHECK(deepest(standing) == Approx(0.01).epsilon(1e-4));
  CHECK(contact_manifold(k_cube, above(Real(0.49)), ground, {}, swapped(down)).count
        == 4);

  const Sphere ball{Real(0.5)};
  const Manifold resting = contact_manifold(ground, {}, ball, above(Real(0.49)), down);
  REQUIRE(resting.count == 1);
  CHECK(resting.points[0].depth == -down.distance);
  CHECK(resting.points[0].position.z == Approx(-0.005));
}

TEST_CASE("far from the origin the points are as good as the positions") {
  const Vec3 far(Real(1e6), Real(-2e6), Real(3e6));
  const Pose lower{far}, upper{far + Vec3(Real(0.25), Real(0.25), 1)};
  const Manifold m = manifold_of(k_cube, lower, k_cube, upper);
  REQUIRE(m.count == 4);
  for (const ContactPoint& p : points_of(m)) CHECK(std::abs(p.depth) <= 16 * k_u);
}
