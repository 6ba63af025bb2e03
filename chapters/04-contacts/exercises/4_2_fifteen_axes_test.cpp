// Boxes whose depth one can see, and any two boxes beside the engine's GJK and EPA,
// which know nothing of axes.
#include "chapters/04-contacts/exercises/4_2_fifteen_axes.hpp"

#include <cmath>

#include "common/physics/epa.hpp"
#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// Axes closer to parallel than 1e-8 may be left out: that much of the boxes, and some
// roundings
constexpr double k_tolerance = 2e-8;

const Box k_cube{{1, 1, 1}};

Real exact_depth(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Shape shape_a = a, shape_b = b;
  return -separation(convex(shape_a), pose_a, convex(shape_b), pose_b).distance;
}

}  // namespace

TEST_CASE("overlaps along a direction") {
  const Pose at_2{{1.5, 0, 0}, {1, 0, 0, 0}}, apart{{0, 5, 0}, {1, 0, 0, 0}};
  expect("overlap [m] of two cubes 1.5 m apart along x",
         overlap(k_cube, {}, k_cube, at_2, {1, 0, 0}), 0.5, 4 * k_u);
  expect("the same along -x", overlap(k_cube, {}, k_cube, at_2, {-1, 0, 0}), 3.5,
         8 * k_u);
  expect("overlap [m] across a gap of 3 m",
         overlap(k_cube, {}, k_cube, apart, {0, 1, 0}), -3, 8 * k_u);
  const Vec3 diagonal = glm::normalize(Vec3(1, 1, 1));
  expect("overlap [m] of two cubes in one place along their diagonal",
         overlap(k_cube, {}, k_cube, {}, diagonal), 2 * std::sqrt(3.0), 16 * k_u);
}

TEST_CASE("faces: the depth of cubes along the axes") {
  for (const Vec3& from : {Vec3(1.5, 0.2, 0.1), Vec3(-0.1, -1.5, 0.3), Vec3(0, 0, 1.5)})
    expect(fmt::format("depth [m] of a cube at ({}, {}, {})", from.x, from.y, from.z),
           penetration_depth(k_cube, {}, k_cube, {from, {1, 0, 0, 0}}), 0.5, 8 * k_u);
}

TEST_CASE("edges: two crossing blades, one above the other") {
  // Each turned by 45 degrees about its own length, so that they meet edge to edge, 0.1
  // m deep
  const Box along_x{{3, 1, 1}}, along_y{{1, 3, 1}};
  const double c = std::cos(std::acos(-1.0) / 8), s = std::sin(std::acos(-1.0) / 8);
  const Pose below{{0, 0, 0}, {c, s, 0, 0}};
  const Pose above{{0, 0, 2 * std::sqrt(2.0) - 0.1}, {c, 0, s, 0}};
  expect("depth [m] of the blades", penetration_depth(along_x, below, along_y, above),
         0.1, k_tolerance);
}

TEST_CASE("any two boxes, nearly parallel ones among them") {
  Random random(2);
  int overlapping = 0;
  for (int i = 0; i < 3000; ++i) {
    const Box a{random.sizes(0.3, 2)}, b{random.sizes(0.3, 2)};
    const Pose pose_a{{0, 0, 0}, random.turn()};
    Pose pose_b{random.between(0, 2) * random.direction(), random.turn()};
    if (i % 3 == 0)
      pose_b.orientation = glm::normalize(
          pose_a.orientation + random.log_between(1e-17, 1e-3) * pose_b.orientation);
    const Real right = exact_depth(a, pose_a, b, pose_b);
    const Real yours = penetration_depth(a, pose_a, b, pose_b);
    if (right < 0) {
      if (!(yours < k_tolerance))
        FAIL(fmt::format("pair {}: yours overlap by {:.8g} m, they are {:.8g} m apart",
                         i, yours, -right));
      continue;
    }
    ++overlapping;
    expect(fmt::format("depth [m] of pair {}", i), yours, right, 4 * k_tolerance);
  }
  REQUIRE(overlapping > 1000);
}
