/// @file
/// Convex polyhedra at random, in the precision at hand: what the tests of chapter 4
/// are made from.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off

/// The same numbers from every standard library.
struct Random {
  explicit Random(unsigned seed) : bits(seed) {}

  double between(double low, double high) {
    return low + (high - low) * double(bits() >> 11) * 0x1p-53;
  }
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  Vec3 in_cube(double half = 1) {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  Vec3 sizes(double low, double high) {
    const double x = log_between(low, high), y = log_between(low, high);
    return {x, y, log_between(low, high)};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_cube();
      const Real length = glm::length(v);
      if (length > Real(0.1) && length < 1) return v / length;
    }
  }
  Quat turn() {
    for (;;) {
      const Vec3 v = in_cube();
      const Quat q(Real(between(-1, 1)), v);
      if (glm::length(q) > Real(0.1) && glm::length(q) < 1) return glm::normalize(q);
    }
  }

  std::mt19937_64 bits;
};

/// Of n points, in a cube, on a sphere, or both of them squeezed.
inline ConvexHull random_hull(Random& random, int n) {
  const bool on_sphere = random.bits() % 2 == 0, is_squeezed = random.bits() % 3 == 0;
  const Vec3 squeeze = random.sizes(1e-2, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = on_sphere ? random.direction() : random.in_cube();
    points.push_back(is_squeezed ? p * squeeze : p);
  }
  return convex_hull(points).hull;
}

inline ConvexHull box_hull(const Vec3& half) {
  std::vector<Vec3> points;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) points.push_back(half * Vec3(x, y, z));
  return convex_hull(points).hull;
}

/// The gap between two hulls along a direction of length one, negative if they overlap,
/// by looking at every vertex.
inline double gap_along(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
                        const Pose& pose_b, const glm::dvec3& n) {
  const auto extreme = [&](const ConvexHull& hull, const Pose& pose, double sign) {
    const glm::dvec3 in_body = glm::conjugate(glm::dquat(pose.orientation)) * n;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : hull.vertices)
      most = std::max(most, sign * glm::dot(glm::dvec3(v), in_body));
    return sign * most;
  };
  const glm::dvec3 t = glm::dvec3(pose_b.position) - glm::dvec3(pose_a.position);
  return glm::dot(n, t) + extreme(b, pose_b, -1) - extreme(a, pose_a, 1);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
