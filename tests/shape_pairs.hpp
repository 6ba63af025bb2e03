/// @file
/// Random pairs of shapes, and the signed distance of two small point clouds' hulls by
/// trying every direction that can be the best.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "common/physics/epa.hpp"
#include "tests/polyhedra.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

inline constexpr bool k_single = std::is_same_v<Real, float>;

/// The shapes that have support points, in the order of Shape without the half-space.
inline constexpr int k_shape_kinds = 7;
inline constexpr std::array k_shape_names{"sphere",   "box",  "ellipsoid", "capsule",
                                          "cylinder", "cone", "hull"};

/// Of about this size; needles, slabs and all between. A hull's vertices go to
/// `points`.
inline Shape random_shape(Random& random, int kind, double size,
                          std::vector<Vec3>& points) {
  const double thinnest = k_single ? 1e-2 : 1e-4;
  const Real s = Real(size), t = Real(size * random.log_between(thinnest, 1));
  const Real third = random.bits() % 2 == 0 ? t : s;
  const bool slab = random.bits() % 2 == 0;
  const Real radius = slab ? s : t, height = slab ? t : s;
  switch (kind) {
    case 0:
      return Sphere{s};
    case 1:
      return Box{{s, t, third}};
    case 2:
      return Ellipsoid{{s, std::max(t, s / 16), std::max(third, s / 16)}};
    case 3:
      return Capsule{radius, height};
    case 4:
      return Cylinder{radius, height};
    case 5:
      return Cone{radius, height};
    default:
      break;
  }
  points.clear();
  const int count = 4 + int(random.bits() % 28);
  for (int i = 0; i < count; ++i)
    points.push_back(Vec3(s, t, third) * random.in_cube());
  return hull_shape(points);
}

struct Pair {
  Shape a, b;
  Pose pose_a, pose_b;
  std::array<std::vector<Vec3>, 2> points;  ///< of hulls
};

inline Separation separation_of(const Pair& p) {
  return separation(convex(p.a), p.pose_a, convex(p.b), p.pose_b);
}

/// Turned anyhow, along the same axes, or nearly so.
inline Pose some_pose(Random& random, const Pose& other, double reach) {
  Pose pose{Real(reach * random.between(0, 1)) * random.direction(), random.turn()};
  const auto kind = random.bits() % 4;
  if (kind == 0) pose.orientation = other.orientation;
  if (kind == 1)
    pose.orientation =
        glm::normalize(other.orientation + Real(1e-7) * pose.orientation);
  return pose;
}

/// Moves B until the shapes are a given distance apart.
inline void bring_to(Pair& pair, double distance) {
  const Separation s = separation_of(pair);
  pair.pose_b.position += (Real(distance) - s.distance) * s.normal;
}

using Exact = long double;
using ExactVec3 = glm::vec<3, Exact>;

inline ExactVec3 place(const Pose& pose, const Vec3& from, const Vec3& point) {
  const glm::qua<Exact> q(pose.orientation);
  const ExactVec3 u(q.x, q.y, q.z), v(point);
  const ExactVec3 t = Exact(2) * glm::cross(u, v);
  const Exact norm = q.w * q.w + glm::dot(u, u);
  return (q.w * t + glm::cross(u, t)) / norm + v
         + (ExactVec3(pose.position) - ExactVec3(from));
}

/// How far B's hull reaches back into A's along a direction: no smaller shift along it
/// takes them apart.
inline Exact overlap(std::span<const ExactVec3> a, std::span<const ExactVec3> b,
                     const ExactVec3& direction) {
  const ExactVec3 n = glm::normalize(direction);
  Exact most_a = -std::numeric_limits<Exact>::infinity(), least_b = -most_a;
  for (const ExactVec3& p : a) most_a = std::max(most_a, glm::dot(n, p));
  for (const ExactVec3& p : b) least_b = std::min(least_b, glm::dot(n, p));
  return most_a - least_b;
}

/// The signed distance of the hulls of two small clouds (a point and more): the
/// greatest gap along all normals of planes through three points of one or an edge of
/// each, and all ways from a vertex to a vertex or an edge.
inline double brute_force_distance(std::span<const ExactVec3> a,
                                   std::span<const ExactVec3> b) {
  Exact least = std::numeric_limits<Exact>::infinity();
  const auto offer = [&](const ExactVec3& n) {
    if (!(glm::dot(n, n) > 0)) return;
    least = std::min({least, overlap(a, b, n), overlap(a, b, -n)});
  };
  const auto edges_of = [](std::span<const ExactVec3> points) {
    std::vector<std::array<ExactVec3, 2>> edges;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j)
        edges.push_back({points[i], points[j] - points[i]});
    return edges;
  };
  const auto edges_a = edges_of(a), edges_b = edges_of(b);
  const auto offer_planes = [&](std::span<const ExactVec3> points, const auto& edges) {
    for (const auto& [from, e] : edges)
      for (const ExactVec3& p : points) offer(glm::cross(e, p - from));
  };
  const auto offer_ways = [&](std::span<const ExactVec3> points, const auto& edges) {
    for (const auto& [from, e] : edges)
      for (const ExactVec3& p : points) offer(glm::cross(e, glm::cross(p - from, e)));
  };
  offer_planes(a, edges_a);
  offer_planes(b, edges_b);
  offer_ways(a, edges_b);
  offer_ways(b, edges_a);
  for (const auto& [p, e] : edges_a)
    for (const auto& [q, f] : edges_b) offer(glm::cross(e, f));
  for (const ExactVec3& p : a)
    for (const ExactVec3& q : b) offer(q - p);
  return double(-least);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
