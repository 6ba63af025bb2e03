// Chapter 4's compound shapes. Compiled for each precision; u (k_u) is the unit
// round-off of the one at hand.
#include <algorithm>
#include <array>
#include <vector>

#include "common/physics/compound.hpp"
#include "tests/allocations.hpp"
#include "tests/catch.hpp"
#include "tests/obj_mesh.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

// An L of two boxes, 3 wide and 2 high, 1 thick: its notch is above (1, 1)
const std::array k_corner_piece{
    CompoundPart{Box{{Real(1.5), Real(0.5), Real(0.5)}}, {{Real(1.5), Real(0.5), 0}}},
    CompoundPart{Box{{Real(0.5), Real(0.5), Real(0.5)}}, {{Real(0.5), Real(1.5), 0}}}};

std::array<CompoundPart, 1> ball(Real radius) {
  return {CompoundPart{Sphere{radius}}};
}

std::vector<CompoundPart> random_parts(Random& random,
                                       std::vector<std::vector<Vec3>>& points) {
  std::vector<CompoundPart> parts;
  const auto count = 1 + random.bits() % 6;
  points.resize(count);
  for (std::vector<Vec3>& own : points) {
    const int kind = int(random.bits() % k_shape_kinds);
    parts.push_back(
        {random_shape(random, kind, 0.5, own), {random.in_cube(0.7), random.turn()}});
  }
  return parts;
}

Pose part_in_world(const Pose& body, const Pose& part) {
  return {point_in_world(body, part.position), body.orientation * part.orientation};
}

}  // namespace

TEST_CASE("bounds and volume of a corner piece are those of its boxes") {
  CHECK(double(volume(k_corner_piece)) == Approx(4).epsilon(4 * k_u));
  const Bounds box = bounds(k_corner_piece, {{10, 0, 0}});
  CHECK(double(glm::distance(box.low, Vec3(10, 0, Real(-0.5)))) <= 32 * k_u);
  CHECK(double(glm::distance(box.high, Vec3(13, 2, Real(0.5)))) <= 32 * k_u);
}

TEST_CASE("a ball in the notch of a corner piece is as far from it as from its sides") {
  const Real r = Real(0.25);
  for (const Real x : {Real(-0.1), Real(0.05), Real(0.3)})
    for (const Real y : {Real(-0.05), Real(0.1), Real(0.2)}) {
      const auto sphere = ball(r);
      const Pose pose{{1 + r + x, 1 + r + y, 0}};
      const PartSeparation found = separation(k_corner_piece, {}, sphere, pose);

      // Coordinates up to 4 at eight roundings each
      const double within = 32 * k_u;
      CHECK(double(found.separation.distance)
            == Approx(double(std::min(x, y))).margin(within));
      CHECK(found.part_a == (x < y ? 1U : 0U));
      CHECK(double(found.separation.normal[x < y ? 0 : 1]) == Approx(1).margin(within));

      // A manifold for each side that it touches
      std::array<PartContact, 4> contacts{};
      const std::size_t count =
          contact_manifolds(k_corner_piece, {}, sphere, pose, 0, contacts);
      CHECK(count == std::size_t(x < 0) + std::size_t(y < 0));
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [parts, manifold] = contacts[i];
        CHECK(manifold.count == 1);
        const Real depth = parts.part_a == 1 ? -x : -y;
        CHECK(double(manifold.points[0].depth) == Approx(double(depth)).margin(within));
      }
    }
}

TEST_CASE("no pair of parts that is left out is closer") {
  Random random(17);
  int overlapping = 0, skipped = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::vector<Vec3>> points_a, points_b;
    const auto a = random_parts(random, points_a), b = random_parts(random, points_b);
    const Pose pose_a{random.in_cube(3), random.turn()};
    const Pose pose_b{pose_a.position + random.in_cube(1.5), random.turn()};
    const PartSeparation found = separation(a, pose_a, b, pose_b);
    const Separation& s = found.separation;

    double least = 1e9;
    std::size_t touching = 0;
    int iterations = 0;
    double error = double(s.error);
    for (const CompoundPart& p : a)
      for (const CompoundPart& q : b) {
        const Separation each = separation(p.shape, part_in_world(pose_a, p.pose),
                                           q.shape, part_in_world(pose_b, q.pose));
        least = std::min(least, double(each.distance));
        touching += each.distance <= 0;
        iterations += each.iterations;
        error = std::max(error, double(each.error));
      }

    // Poses are multiplied from A's position there, and from the origin here; smooth
    // shapes at EPA's limit are right to 1e-3 of their size
    INFO(i << " " << name_of(s.reason));
    const double within = s.reason == Reason::iteration_limit ? 1e-3 : 16 * error;
    REQUIRE(double(s.distance) == Approx(least).margin(within));
    const Vec3 left = s.on_b - s.on_a - s.distance * s.normal;
    REQUIRE(double(glm::length(left)) <= 128 * k_u * 10);
    skipped += s.iterations < iterations;
    overlapping += touching > 0;

    // Asked for the other way round it is the same; there is a manifold for each pair
    // that touches, as many as there is room for
    REQUIRE(double(separation(b, pose_b, a, pose_a).separation.distance)
            == Approx(double(s.distance)).margin(within));
    std::array<PartContact, 2> contacts{};
    const int before = allocations;
    const std::size_t count = contact_manifolds(a, pose_a, b, pose_b, 0, contacts);
    REQUIRE(allocations == before);
    REQUIRE(count == touching);
    for (std::size_t k = 0; k < std::min(count, contacts.size()); ++k)
      REQUIRE(contacts[k].manifold.count >= 1);
  }
  CHECK(overlapping > 500);
  CHECK(overlapping < 1700);
  CHECK(skipped > 1000);
}

TEST_CASE(
    "a body in a hollow of the wrench is apart from its parts, not from its hull") {
  const ObjMesh mesh = read_obj(TIMESTEP_MESHES "/wrench.obj");
  const Decomposition wrench = decompose(mesh.vertices, mesh.triangles);
  REQUIRE(wrench.parts.size() > 4);
  const std::vector<CompoundPart> parts = compound_parts(wrench);
  const ConvexHull hull = convex_hull(mesh.vertices).hull;
  const std::array whole{CompoundPart{hull_shape(hull)}};
  CHECK(double(volume(parts)) == Approx(double(wrench.parts_volume)).epsilon(1e-5));

  // A small ball wherever it is in the hull: never closer to the hull than to the
  // parts, and never farther from the parts than from the mesh's nearest vertex
  Random random(18);
  const Real radius = hull.reach / 200;
  const auto small = ball(radius);
  int hollow = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half = bounds(whole, {}).high;
    const Pose pose{half * random.in_cube()};
    const double to_hull =
        double(separation(whole, {}, small, pose).separation.distance);
    const double to_parts =
        double(separation(parts, {}, small, pose).separation.distance);
    double to_vertex = 1e9;
    for (const Vec3& v : mesh.vertices)
      to_vertex = std::min(to_vertex, double(glm::distance(v, pose.position) - radius));
    const double within = 256 * k_u * double(hull.reach);
    REQUIRE(to_hull <= to_parts + within);
    REQUIRE(to_parts <= to_vertex + within);
    hollow += to_hull < 0 && to_parts > 0;
  }
  CHECK(hollow > 100);
}

TEST_CASE("compounds without parts and numbers that are none have no answer") {
  const Compound nothing;
  CHECK(separation(nothing, {}, k_corner_piece, {}).separation.reason
        == Reason::no_answer);
  CHECK(contact_manifolds(nothing, {}, k_corner_piece, {}, 1, {}) == 0);
  constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();
  const Pose nowhere{{k_nan, 0, 0}};
  CHECK(separation(k_corner_piece, {}, k_corner_piece, nowhere).separation.reason
        == Reason::out_of_range);
  CHECK(contact_manifolds(k_corner_piece, {}, k_corner_piece, nowhere, 1, {}) == 0);

  // On a half-space, which has no bounds
  const std::array ground{CompoundPart{HalfSpace{{0, 1, 0}, 0}}};
  const Pose low{{0, Real(-0.25), 0}};
  CHECK(separation(k_corner_piece, low, ground, {}).separation.distance == Real(-0.25));
  std::array<PartContact, 2> contacts{};
  CHECK(contact_manifolds(k_corner_piece, low, ground, {}, 0, contacts) == 1);
  CHECK(contacts[0].manifold.count == 4);
}
