#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "common/chapter/random.hpp"
#include "common/physics/pair_query.hpp"
#include "common/physics/primitives.hpp"
#include "common/physics/sat.hpp"
#include "study/ingredients/contacts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {
namespace {

using study::Comparison;
using study::Motion;

constexpr int k_pairs = 64;

struct Pair {
  Pose a, b;
  double depth;  // [m]
};
using Pairs = std::array<Pair, k_pairs>;

Pose random_pose(Random& random) {
  const auto number = [&] { return Real(random.uniform(-1, 1)); };
  Pose pose;
  for (const glm::length_t i : {0, 1, 2}) pose.position[i] = Real(0.4) * number();
  const Real w = number(), x = number(), y = number(), z = number();
  pose.orientation = glm::normalize(Quat{w, x, y, z});
  return pose;
}

// Those that overlap; `depth_of` is not positive where they do not
Pairs overlapping(const auto& depth_of) {
  Random random(1);
  Pairs pairs{};
  for (int found = 0; found < k_pairs;) {
    Pair& pair = pairs[std::size_t(found)];
    pair = {random_pose(random), random_pose(random), 0};
    pair.depth = double(depth_of(pair));
    if (pair.depth > 0) ++found;
  }
  return pairs;
}

// The mean error of the depths
Motion asking(const Pairs& pairs, const auto& depth_of) {
  struct Asked {
    Pairs pairs;
    std::array<Real, k_pairs> depths{};
  };
  auto asked = std::make_shared<Asked>(Asked{pairs});
  return {[=] {
            for (std::size_t i = 0; i < k_pairs; ++i)
              asked->depths[i] = depth_of(asked->pairs[i]);
          },
          [=] {
            double sum = 0;
            for (std::size_t i = 0; i < k_pairs; ++i)
              sum += std::abs(double(asked->depths[i]) - asked->pairs[i].depth);
            return sum / k_pairs;
          }};
}

Comparison depths(const std::string& scene, bool matters, const std::string& exact) {
  return {.ingredient = "EPA",
          .scene = scene,
          .matters = matters,
          .metric = "depth",
          .unit = "m",
          .exact = exact,
          .steps = 10,
          .bodies = k_pairs,
          .with = {"GJK and EPA", {}},
          .without = {"spheres", {}}};
}

Real sphere_depth(const Sphere& sphere, const Pair& pair) {
  return -sphere_sphere(sphere, pair.a, sphere, pair.b).distance;
}

Real depth_of(const Shape& shape, const Pair& pair) {
  return -separation(shape, pair.a, shape, pair.b).distance;
}

Comparison boxes() {
  Comparison row = depths("boxes that overlap", true, "separating axes");
  const Box box{{Real(0.5), Real(0.25), Real(0.125)}};
  const Vec3& half = box.half_extents;
  const Sphere sphere{
      std::cbrt(6 * half.x * half.y * half.z / std::numbers::pi_v<Real>)};
  const Pairs pairs = overlapping([&](const Pair& pair) {
    return -sat(box, pair.a, box, pair.b).separation.distance;
  });
  row.with.start = [=] {
    return asking(pairs, [=](const Pair& pair) { return depth_of(box, pair); });
  };
  row.without.name = "spheres of the boxes' volume";
  row.without.start = [=] {
    return asking(pairs, [=](const Pair& pair) { return sphere_depth(sphere, pair); });
  };
  return row;
}

Comparison balls() {
  Comparison row = depths("balls that overlap", false, "distance of the centres");
  const Sphere sphere{Real(0.5)};
  const Pairs pairs = overlapping([&](const Pair& pair) {
    return 1 - glm::distance(glm::dvec3(pair.a.position), glm::dvec3(pair.b.position));
  });
  row.with.start = [=] {
    return asking(pairs, [=](const Pair& pair) { return depth_of(sphere, pair); });
  };
  row.without.start = [=] {
    return asking(pairs, [=](const Pair& pair) { return sphere_depth(sphere, pair); });
  };
  return row;
}

}  // namespace

std::vector<Comparison> pair_comparisons() {
  return {boxes(), balls()};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
