// The pairs, and how far apart they are: found by methods that are not measured, or
// proven. In double.
#include "bench/contact_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "common/physics/convex_hull.hpp"
#include "common/physics/epa.hpp"
#include "common/physics/primitives.hpp"

namespace timestep::contact_bench {
namespace {

constexpr std::size_t k_half = 1000;  // so many pairs overlap, and as many do not
constexpr std::size_t k_shapes = 16;  // that the pairs of a set are drawn from
constexpr double k_least = 1e-3;      // [m] no pair is closer to touching

// What is proven must meet what is measured by this [m], a thousand roundings
constexpr double k_proof = 1e-13;

// --- At random, the same everywhere

struct Random {
  std::mt19937_64 bits;

  double between(double low, double high) {
    return low + (high - low) * double(bits() >> 11) * 0x1p-53;
  }
  glm::dvec3 in_cube() {
    const double x = between(-1, 1), y = between(-1, 1);
    return {x, y, between(-1, 1)};
  }
  glm::dvec3 in_ball() {
    for (;;)
      if (const glm::dvec3 v = in_cube(); glm::length(v) < 1) return v;
  }
  glm::dquat turn() {
    for (;;) {
      const glm::dquat q(between(-1, 1), in_cube());
      if (glm::length(q) > 0.1 && glm::length(q) < 1) return glm::normalize(q);
    }
  }
  glm::dvec3 sizes(double least) {
    const double x = between(least, 1), y = between(least, 1);
    return {x, y, between(least, 1)};
  }
};

Solid ball(Random& random) {
  return {.radius = random.between(0.2, 1)};
}

Solid box(Random& random) {
  return {.half_extents = random.sizes(0.2)};
}

// Points of an ellipsoid's surface: each is a vertex of their hull
Solid hull(Random& random, std::size_t vertices) {
  Solid solid;
  const glm::dvec3 semi_axes = random.sizes(0.5);
  for (std::size_t i = 0; i < vertices; ++i)
    solid.vertices.push_back(semi_axes * glm::normalize(random.in_ball()));
  return solid;
}

// --- How far apart

Pose pose_of(const Place& place) {
  return {place.position, place.orientation};
}

ConvexHull hull_of(const Solid& solid) {
  std::vector<glm::dvec3> points = solid.vertices;
  if (points.empty())
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        for (const double z : {-1.0, 1.0})
          points.push_back(solid.half_extents * glm::dvec3(x, y, z));
  return convex_hull(points).hull;
}

// Two hulls in the frame of the first
struct HullPair {
  const ConvexHull& a;
  const ConvexHull& b;
  Mat3 R;
  glm::dvec3 t;

  std::uint32_t near_a = 0, near_b = 0;  // vertices from which to climb

  // What A reaches farthest forward along a direction, and B back
  glm::dvec3 front(const glm::dvec3& n) const {
    return a.vertices[support_vertex(hull_shape(a), n, near_a)];
  }
  glm::dvec3 back(const glm::dvec3& n) const {
    return R * b.vertices[support_vertex(hull_shape(b), -n * R, near_b)] + t;
  }

  // How far B reaches back into A along a direction of length one
  double overlap(const glm::dvec3& n) const { return glm::dot(n, front(n) - back(n)); }
};

// The overlap across an edge of A, from one point along a vector, and any edge of B, if
// that is less
double least_across(const HullPair& pair, const glm::dvec3& from,
                    const glm::dvec3& along, const glm::dvec3& outwards, double least) {
  const auto& [a, b, R, t, near_a, near_b] = pair;
  for (const HalfEdge& f : b.half_edges) {
    const glm::dvec3& start = b.vertices[f.origin];
    const glm::dvec3& end = b.vertices[b.half_edges[f.twin].origin];
    const glm::dvec3 across = glm::cross(along, R * (end - start));
    if (glm::dot(across, outwards) <= 0) continue;
    const glm::dvec3 n = glm::normalize(across);
    if (glm::dot(n, from - (R * start + t)) < least)
      least = std::min(least, pair.overlap(n));
  }
  return least;
}

// The overlap along any direction is at least the depth, and along the right one it is
// the depth: that of a face, or across an edge of each. It is at least that of any two
// points, such as those that are deepest along the direction found, and between the
// normals of two faces that is least at one of them: so most need no closer look.
double least_overlap(HullPair pair, const glm::dvec3& found) {
  const auto& [a, b, R, t, near_a, near_b] = pair;
  pair.near_a = support_vertex(hull_shape(a), found, 0);
  pair.near_b = support_vertex(hull_shape(b), -found * R, 0);
  const glm::dvec3 deepest_a = pair.front(found), deepest_b = pair.back(found);
  double least = glm::dot(found, deepest_a - deepest_b);
  for (const auto& [normal, offset] : a.planes)
    if (offset - glm::dot(normal, deepest_b) < least)
      least = std::min(least, pair.overlap(normal));
  for (const auto& [normal, offset] : b.planes)
    if (offset - glm::dot(R * normal, deepest_a - t) < least)
      least = std::min(least, pair.overlap(-(R * normal)));
  for (const HalfEdge& e : a.half_edges) {
    const HalfEdge& twin = a.half_edges[e.twin];
    const glm::dvec3 &left = a.planes[e.face].normal,
                     &right = a.planes[twin.face].normal;
    const glm::dvec3 &from = a.vertices[e.origin], &to = a.vertices[twin.origin];
    const auto may_be_less = [&](const glm::dvec3& back) {
      return std::min(glm::dot(left, from - back), glm::dot(right, from - back))
             < least;
    };
    if (&e < &twin && may_be_less(deepest_b) && may_be_less(pair.back(left + right)))
      least = least_across(pair, from, to - from, left + right, least);
  }
  return least;
}

double height_above(const ConvexHull& hull, const glm::dvec3& point) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& [normal, offset] : hull.planes)
    most = std::max(most, glm::dot(normal, point) - offset);
  return most;
}

// Of separated hulls: between the gap along a direction and the distance of two points
// that are in them
double proven_distance(const HullPair& pair, const Pose& pose_a, const Pose& pose_b,
                       const Separation& s) {
  const double gap = -pair.overlap(direction_in_body(pose_a, s.normal));
  const double outside = std::max(height_above(pair.a, point_in_body(pose_a, s.on_a)),
                                  height_above(pair.b, point_in_body(pose_b, s.on_b)));
  if (outside > k_proof || glm::distance(s.on_a, s.on_b) - gap > k_proof) {
    fmt::print(stderr, "bench: a distance of {} m is not proven\n", gap);
    std::exit(1);
  }
  return gap;
}

double distance_of_hulls(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
                         const Pose& pose_b) {
  const Pose b_in_a = relative_pose(pose_a, pose_b);
  const HullPair pair{a, b, matrix_of(b_in_a.orientation), b_in_a.position};
  const Shape shape_a = hull_shape(a), shape_b = hull_shape(b);
  const Separation s = separation(convex(shape_a), pose_a, convex(shape_b), pose_b);
  if (s.distance > 0) return proven_distance(pair, pose_a, pose_b, s);
  return -least_overlap(pair, direction_in_body(pose_a, s.normal));
}

// --- Sets

Place moved(Random& random, const Place& place) {
  const glm::dquat turn(1, 0.01 * random.in_cube());
  return {place.position + 0.01 * random.in_cube(),
          glm::normalize(turn * place.orientation)};
}

double reach(const Solid& solid) {
  double most = std::max(solid.radius, glm::length(solid.half_extents));
  for (const glm::dvec3& v : solid.vertices) most = std::max(most, glm::length(v));
  return most;
}

// B anywhere in a ball around A, in which they meet about every other time.
// `distance_of` takes a pair of solids
PairSet random_pairs(Random& random, std::vector<Solid> solids, std::size_t half,
                     const auto& distance_of) {
  PairSet set{std::move(solids), {}};
  std::vector<SolidPair> overlapping, separated;
  const std::size_t n = set.solids.size() / 2;
  for (std::size_t i = 0; overlapping.size() < half || separated.size() < half; ++i) {
    SolidPair pair{i % n, n + i / n % n, {}, {}, {}, 0};
    const double size = reach(set.solids[pair.a]) + reach(set.solids[pair.b]);
    pair.place_a = {random.in_cube(), random.turn()};
    pair.place_b = {pair.place_a.position + size * random.in_ball(), random.turn()};
    pair.moved_b = moved(random, pair.place_b);
    pair.distance = distance_of(pair);
    auto& kind = pair.distance < 0 ? overlapping : separated;
    if (kind.size() < half && std::abs(pair.distance) > k_least) kind.push_back(pair);
  }
  set.pairs = std::move(overlapping);
  set.pairs.insert(set.pairs.end(), separated.begin(), separated.end());
  return set;
}

PairSet pairs_of_hulls(Random& random, std::vector<Solid> solids) {
  std::vector<ConvexHull> hulls;
  for (const Solid& solid : solids) hulls.push_back(hull_of(solid));
  return random_pairs(random, std::move(solids), k_half, [&](const SolidPair& pair) {
    return distance_of_hulls(hulls[pair.a], pose_of(pair.place_a), hulls[pair.b],
                             pose_of(pair.place_b));
  });
}

PairSet make_sphere_box() {
  Random random{std::mt19937_64(41)};
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < k_shapes; ++i)
    solids.push_back(2 * i < k_shapes ? ball(random) : box(random));
  const std::vector<Solid> all = solids;
  return random_pairs(random, std::move(solids), k_half, [&](const SolidPair& pair) {
    return sphere_box({all[pair.a].radius}, pose_of(pair.place_a),
                      {all[pair.b].half_extents}, pose_of(pair.place_b))
        .distance;
  });
}

PairSet make_box_box() {
  Random random{std::mt19937_64(42)};
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < k_shapes; ++i) solids.push_back(box(random));
  return pairs_of_hulls(random, std::move(solids));
}

std::vector<Solid> random_hulls(Random& random, std::size_t vertices) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < k_shapes; ++i) solids.push_back(hull(random, vertices));
  return solids;
}

PairSet make_hulls(std::size_t vertices) {
  Random random{std::mt19937_64(43)};
  return pairs_of_hulls(random, random_hulls(random, vertices));
}

}  // namespace

const PairSet& sphere_box_pairs() {
  static const PairSet set = make_sphere_box();
  return set;
}

const PairSet& box_box_pairs() {
  static const PairSet set = make_box_box();
  return set;
}

const PairSet& hull32_pairs() {
  static const PairSet set = make_hulls(32);
  return set;
}

const PairSet& hull1000_pairs() {
  static const PairSet set = make_hulls(1000);
  return set;
}

PairSet few_pairs_of_hulls(std::size_t vertices) {
  Random random{std::mt19937_64(44)};
  const std::vector<Solid> solids = random_hulls(random, vertices);
  std::vector<ConvexHull> hulls;
  for (const Solid& solid : solids) hulls.push_back(hull_of(solid));
  return random_pairs(random, solids, 8, [&](const SolidPair& pair) {
    const Shape a = hull_shape(hulls[pair.a]), b = hull_shape(hulls[pair.b]);
    return separation(convex(a), pose_of(pair.place_a), convex(b),
                      pose_of(pair.place_b))
        .distance;
  });
}

}  // namespace timestep::contact_bench
