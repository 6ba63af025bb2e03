#include "common/physics/sat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Index = std::uint32_t;

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

// Edges at less than this angle [rad] are parallel: what is across them is a face
// normal
constexpr Real k_parallel = 16 * k_u;

// Where B is in A's frame, in which all of the following is
struct Placement {
  Mat3 R;  // A from B
  Vec3 t;  // of B's origin
};

Placement placement(const Pose& a, const Pose& b) {
  const Pose b_in_a = relative_pose(a, b);
  return {matrix_of(b_in_a.orientation), b_in_a.position};
}

// Rounding in a projection of shapes that reach this far
Real projection_error(Real reach_a, Real reach_b, const Vec3& t) {
  return 16 * k_u * (reach_a + reach_b + glm::length(t));
}

// From A to B, and the features as in SatResult
struct Axis {
  Real separation = -std::numeric_limits<Real>::infinity();
  Vec3 normal{0, 0, 1};
  SatFeature feature = SatFeature::face_of_a;
  Index on_a = 0, on_b = 0;
};

// In place: a copy of what was just written would wait for it
void set(Axis& axis, Real separation, const Vec3& normal, SatFeature feature,
         Index on_a, Index on_b) {
  axis.separation = separation;
  axis.normal = normal;
  axis.feature = feature;
  axis.on_a = on_a;
  axis.on_b = on_b;
}

// What edges must be better than: rounding makes them no better than a face
Real to_beat(const Axis& best, Real error) {
  return best.feature == SatFeature::edges ? best.separation : best.separation + error;
}

// Where the line p + s d is next to the line q + t e; at p if one has no length
Vec3 next_to(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
  const Vec3 n = glm::cross(d, e);
  const Real n2 = glm::dot(n, n);
  if (!(n2 > 0)) return p;
  const Real s = glm::dot(glm::cross(q - p, e), n) / n2;
  return p + std::clamp(s, Real(0), Real(1)) * d;
}

// With the witness point of one shape; that of the other is across the separation
void set_in_world(const Axis& axis, const Vec3& point, const Pose& pose_a,
                  SatResult& result) {
  Separation& s = result.separation;
  s.distance = axis.separation;
  s.normal = direction_in_world(pose_a, axis.normal);
  const bool is_on_b = axis.feature == SatFeature::face_of_a;
  const Vec3 across = axis.separation * axis.normal;
  s.on_a = point_in_world(pose_a, point - (is_on_b ? across : Vec3(0)));
  s.on_b = point_in_world(pose_a, point + (is_on_b ? Vec3(0) : across));
  s.iterations = result.axes;
  result.feature = axis.feature;
  result.on_a = axis.on_a;
  result.on_b = axis.on_b;
}

// --- Two boxes

// Without a branch, which glm::abs has
Vec3 sizes(const Vec3& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

struct BoxPair {
  Vec3 a, b;  // half extents
  Placement b_in_a;
  Mat3 size;  // of the entries of R
};

BoxPair box_pair(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Placement b_in_a = placement(pose_a, pose_b);
  const Mat3& R = b_in_a.R;
  return {
      a.half_extents, b.half_extents, b_in_a, {sizes(R[0]), sizes(R[1]), sizes(R[2])}};
}

// (4.23) Along the face normals of both, whose rows and columns are entries of R
void try_faces(const BoxPair& pair, Axis& best) {
  const auto& [R, t] = pair.b_in_a;
  const Vec3 along_a = sizes(t) - pair.a - pair.size * pair.b;
  const Vec3 along_b = sizes(t * R) - pair.b - pair.a * pair.size;
  for (glm::length_t i = 0; i < 3; ++i) {
    if (along_a[i] <= best.separation) continue;
    set(best, along_a[i], Vec3(0), SatFeature::face_of_a, Index(i), 0);
    best.normal[i] = 1;
  }
  for (glm::length_t i = 0; i < 3; ++i)
    if (along_b[i] > best.separation)
      set(best, along_b[i], R[i], SatFeature::face_of_b, 0, Index(i));
}

// (4.23) The same across edge j of B and each edge of A, times the sine of their angle
Vec3 gaps_across(const BoxPair& pair, glm::length_t j) {
  const auto& [R, t] = pair.b_in_a;
  const glm::length_t k = (j + 1) % 3, l = (j + 2) % 3;
  const Vec3 &a = pair.a, &size = pair.size[j];
  const Vec3 of_a(a.y * size.z + a.z * size.y, a.z * size.x + a.x * size.z,
                  a.x * size.y + a.y * size.x);
  const Vec3 of_b = pair.b[k] * pair.size[l] + pair.b[l] * pair.size[k];
  return sizes(glm::cross(R[j], t)) - of_a - of_b;
}

// The edges i and j, with care: the shorter the cross product, the more of it is
// rounding
void try_edge_pair(const BoxPair& pair, glm::length_t i, glm::length_t j, Real least,
                   Axis& best) {
  const auto& [R, t] = pair.b_in_a;
  Vec3 edge_a(0);
  edge_a[i] = 1;
  const Vec3 across = glm::cross(edge_a, R[j]);
  const Real sine = glm::length(across);
  if (sine <= k_parallel) return;
  const Vec3 L = across / sine;
  const Real s = std::abs(glm::dot(t, L)) - glm::dot(pair.a, sizes(L))
                 - glm::dot(pair.b, sizes(L * R));
  if (s > least) set(best, s, L, SatFeature::edges, Index(i), Index(j));
}

void try_edges(const BoxPair& pair, Real error, Axis& best) {
  for (glm::length_t j = 0; j < 3; ++j) {
    const Vec3 gaps = gaps_across(pair, j) + error;
    const Vec3 sines2 = Real(1 + 8 * k_u) - pair.size[j] * pair.size[j];
    const Vec3 sines = glm::sqrt(glm::max(sines2, Real(0)));
    for (glm::length_t i = 0; i < 3; ++i) {
      // Whether the gap over the sine can be the best; if it may, with care
      const Real least = to_beat(best, error);
      if (gaps[i] > least * sines[i]) try_edge_pair(pair, i, j, least, best);
    }
  }
}

// The corner that is furthest along a direction
Vec3 corner(const Vec3& half, const Vec3& along) {
  return {std::copysign(half.x, along.x), std::copysign(half.y, along.y),
          std::copysign(half.z, along.z)};
}

// Of B beside a face of A, else of A
Vec3 witness(const BoxPair& pair, const Axis& axis) {
  const auto& [R, t] = pair.b_in_a;
  const Vec3 on_a = corner(pair.a, axis.normal);
  const Vec3 on_b = R * corner(pair.b, -(axis.normal * R)) + t;
  if (axis.feature == SatFeature::face_of_a) return on_b;
  if (axis.feature == SatFeature::face_of_b) return on_a;

  const auto i = glm::length_t(axis.on_a), j = glm::length_t(axis.on_b);
  Vec3 along_a(0);
  along_a[i] = -2 * on_a[i];
  return next_to(on_a, along_a, on_b, R[j]);
}

// --- Two hulls

struct HullPair {
  const ConvexHull& a;
  const ConvexHull& b;
  Placement b_in_a;
};

// The face of `a` that the rest of `b` is furthest above
struct BestFace {
  Real separation = -std::numeric_limits<Real>::infinity();
  Index face = 0, vertex = 0;  // the latter of b, next to the face
};

BestFace best_face(const ConvexHull& a, const ConvexHull& b, const Placement& b_in_a) {
  const auto& [R, t] = b_in_a;
  const HullShape shape = hull_shape(b);
  BestFace best;
  Index vertex = 0;
  for (Index f = 0; f < a.planes.size(); ++f) {
    const auto& [normal, offset] = a.planes[f];
    const Vec3 down = -(normal * R);
    vertex = support_vertex(shape, down, vertex);
    const Real s = glm::dot(normal, t) - glm::dot(down, b.vertices[vertex]) - offset;
    if (s > best.separation) best = {s, f, vertex};
  }
  return best;
}

// An edge: from a point, along a vector, between the outward normals left and right
struct Edge {
  Vec3 from, along, left, right;
};

Edge edge(const ConvexHull& hull, Index half_edge) {
  const HalfEdge& e = hull.half_edges[half_edge];
  const HalfEdge& twin = hull.half_edges[e.twin];
  const Vec3& from = hull.vertices[e.origin];
  return {from, hull.vertices[twin.origin] - from, hull.planes[e.face].normal,
          hull.planes[twin.face].normal};
}

Edge placed(const Edge& e, const Placement& by) {
  return {by.R * e.from + by.t, by.R * e.along, by.R * e.left, by.R * e.right};
}

// (4.24) Two edges make a face of the Minkowski difference A - B if, on the unit
// sphere, the arc from one normal to the other of A's edge crosses that of B's,
// mirrored
bool arcs_cross(const Edge& a, const Edge& b) {
  const Real left_b = glm::dot(b.left, a.along), right_b = glm::dot(b.right, a.along);
  if (left_b * right_b >= 0) return false;
  const Real left_a = glm::dot(a.left, b.along), right_a = glm::dot(a.right, b.along);
  return left_a * right_a < 0 && left_b * right_a < 0;
}

// The gap along an axis, with the outermost vertices found again: rounding may have
// made an axis across nearly parallel edges any other
Real separation_along(const HullPair& pair, const Vec3& n, Index from_a, Index from_b) {
  const auto& [R, t] = pair.b_in_a;
  const Vec3 n_in_b = n * R;
  const Index a = support_vertex(hull_shape(pair.a), n, from_a);
  const Index b = support_vertex(hull_shape(pair.b), -n_in_b, from_b);
  return glm::dot(n, t) + glm::dot(n_in_b, pair.b.vertices[b])
         - glm::dot(n, pair.a.vertices[a]);
}

void try_pair(const HullPair& pair, Index e, Index f, const Edge& a, const Edge& b,
              Real error, Axis& best) {
  const Vec3 across = glm::cross(glm::normalize(a.along), glm::normalize(b.along));
  const Real sine = glm::length(across);
  if (sine <= k_parallel) return;

  const Real outwards = glm::dot(across, a.left + a.right);
  const Vec3 n = across / std::copysign(sine, outwards);
  const Real least = to_beat(best, error);
  if (glm::dot(n, b.from - a.from) <= least) return;
  const Real s = separation_along(pair, n, pair.a.half_edges[e].origin,
                                  pair.b.half_edges[f].origin);
  if (s > least) set(best, s, n, SatFeature::edges, e, f);
}

void try_edges(const HullPair& pair, Real error, SatResult& result, Axis& best) {
  for (Index f = 0; f < pair.b.half_edges.size(); ++f) {
    if (pair.b.half_edges[f].twin < f) continue;
    const Edge b = placed(edge(pair.b, f), pair.b_in_a);
    for (Index e = 0; e < pair.a.half_edges.size(); ++e) {
      if (pair.a.half_edges[e].twin < e) continue;
      ++result.edge_pairs;
      const Edge a = edge(pair.a, e);
      if (!arcs_cross(a, b)) continue;
      ++result.axes;
      try_pair(pair, e, f, a, b, error, best);
    }
  }
}

Placement inverse(const Placement& p) {
  return {glm::transpose(p.R), -(p.t * p.R)};
}

}  // namespace

SatResult sat(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const BoxPair pair = box_pair(a, pose_a, b, pose_b);
  const Vec3& t = pair.b_in_a.t;
  SatResult result;
  result.axes = 15;
  result.edge_pairs = 9;
  result.separation.error =
      projection_error(glm::length(pair.a), glm::length(pair.b), t);

  // Faces first, then edges
  Axis best;
  try_faces(pair, best);
  try_edges(pair, result.separation.error, best);

  // A box is the same both ways: the normal goes to B's side
  if (glm::dot(t, best.normal) < 0) best.normal = -best.normal;
  set_in_world(best, witness(pair, best), pose_a, result);
  return result;
}

SatResult sat(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
              const Pose& pose_b) {
  const HullPair pair{a, b, placement(pose_a, pose_b)};
  const auto& [R, t] = pair.b_in_a;
  SatResult result;
  result.separation.error = projection_error(a.reach, b.reach, t);

  // Faces of A, then of B
  const BestFace of_a = best_face(a, b, pair.b_in_a);
  const BestFace of_b = best_face(b, a, inverse(pair.b_in_a));
  Axis best{of_a.separation, a.planes[of_a.face].normal, SatFeature::face_of_a,
            of_a.face, 0};
  Vec3 point = R * b.vertices[of_a.vertex] + t;
  if (of_b.separation > of_a.separation) {
    best = {of_b.separation, -(R * b.planes[of_b.face].normal), SatFeature::face_of_b,
            0, of_b.face};
    point = a.vertices[of_b.vertex];
  }
  result.axes = int(a.planes.size() + b.planes.size());

  // Edges
  try_edges(pair, result.separation.error, result, best);
  if (best.feature == SatFeature::edges) {
    const Edge on_a = edge(a, best.on_a),
               on_b = placed(edge(b, best.on_b), pair.b_in_a);
    point = next_to(on_a.from, on_a.along, on_b.from, on_b.along);
  }
  set_in_world(best, point, pose_a, result);
  return result;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
