#include "common/physics/epa.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Index = std::int16_t;

constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

// A first tetrahedron takes GJK's own points where they are at least so far apart
constexpr Real k_thin = Real(1) / 1024;

// The farthest point found so far, by some measure of how far
struct Farthest {
  SupportPoint point;
  Real height = 0;

  template <class Height>
  void offer(const SupportPoint& p, const Height& height_of) {
    const Real h = height_of(p.w);
    if (!(h > height)) return;
    point = p;
    height = h;
  }
};

// Of the simplex's points, and if those are near, of the support points along the
// directions and against them
template <class Height>
Farthest farthest(const MinkowskiDifference& difference, const Simplex& simplex,
                  std::span<const Vec3> directions, const Height& height) {
  Farthest best;
  for (int i = 0; i < simplex.size; ++i)
    best.offer(simplex.vertices[std::size_t(i)], height);
  if (best.height > k_thin) return best;
  for (const Vec3& d : directions) {
    best.offer(support(difference, d, simplex.vertices[0]), height);
    best.offer(support(difference, -d, simplex.vertices[0]), height);
  }
  return best;
}

// Where the difference ends along a direction; kept if it is the least depth so far
SupportPoint measure(const MinkowskiDifference& difference, Epa& epa,
                     const Vec3& outward, const std::array<Index, 3>& face) {
  const SupportPoint& near = epa.polytope.vertices[std::size_t(face[0])];
  const SupportPoint far = support(difference, -outward, near);
  ++epa.iterations;
  const Real depth = glm::dot(outward, far.w);
  if (depth < epa.depth) {
    epa.depth = depth;
    epa.outward = outward;
    epa.face = face;
  }
  return far;
}

void finish(Epa& epa, Reason reason) {
  epa.reason = reason;
  epa.done = true;
}

// Where all is in one plane, line or point, the depth is along a normal of that
void finish_flat(const MinkowskiDifference& difference, Epa& epa, const Vec3& normal) {
  epa.depth = -glm::dot(normal, support(difference, normal).w);
  epa.outward = -normal;
  const Real other = glm::dot(normal, support(difference, -normal).w);
  epa.iterations = 2;
  if (other < epa.depth) {
    epa.depth = other;
    epa.outward = normal;
  }
  finish(epa, Reason::flat);
}

// The triangle's point closest to a point, as a simplex with weights from A and B
Simplex closest_on_face(const Polytope& polytope, const std::array<Index, 3>& face,
                        const Vec3& point, Real& distance) {
  Simplex simplex;
  simplex.size = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    simplex.vertices[i] = polytope.vertices[std::size_t(face[i])];
    simplex.vertices[i].w -= point;
  }
  distance = glm::length(reduce_to_closest(simplex));
  return simplex;
}

// (4.20) The witness points are where the difference's boundary is closest to the
// origin: on the face found, or on another in the same plane. How far that is from the
// polytope is what the depth may be too large by
Simplex witnesses(const Epa& epa, Real& gap) {
  const Vec3 point = epa.depth * epa.outward;
  Simplex best = closest_on_face(epa.polytope, epa.face, point, gap);
  for (int i = 0; i < epa.polytope.face_count && gap > k_rounding; ++i) {
    Real distance = k_infinity;
    const PolytopeFace& face = epa.polytope.faces[std::size_t(i)];
    if (!(std::abs(face.offset - epa.depth) < gap)) continue;
    const Simplex other = closest_on_face(epa.polytope, face.vertices, point, distance);
    if (!(distance < gap)) continue;
    best = other;
    gap = distance;
  }
  if (epa.reason != Reason::converged) gap = std::max(gap, epa.depth - epa.lower);
  return best;
}

Separation in_world(const MinkowskiDifference& difference, const Pose& pose_a,
                    const Pose& pose_b, const Simplex& witness, Real core_distance,
                    const Vec3& normal, Real gap) {
  const Real radius_a = difference.a.radius, radius_b = difference.b.radius;
  Separation s;
  s.distance = core_distance * difference.unit - (radius_a + radius_b);
  s.normal = direction_in_world(pose_a, normal);

  // The witness points along the normal, where rounding or a smooth surface that the
  // polytope's flat face stands for has left them a little beside it: half way each
  const Vec3 a = point_in_world(pose_a, witness_on_a(witness)) + radius_a * s.normal;
  const Vec3 b = point_in_world(pose_b, witness_on_b(witness)) - radius_b * s.normal;
  const Vec3 beside = (b - a - s.distance * s.normal) / Real(2);
  s.on_a = a + beside;
  s.on_b = b - beside;
  s.error = k_rounding * (difference.unit + radius_a + radius_b);
  if (gap > k_rounding) s.error += gap * difference.unit;
  return s;
}

// (4.21) Where the cores meet, or are so close that only planes through their features
// tell: what EPA found, unless GJK's bounds are closer
Separation separation_by_epa(const MinkowskiDifference& difference, const Gjk& gjk,
                             const Pose& pose_a, const Pose& pose_b) {
  Epa epa;
  epa_start(difference, gjk.simplex, epa);
  while (!epa.done) epa_step(difference, epa);
  const Real distance = glm::length(gjk.v), gjk_gap = distance - gjk.lower;
  const bool is_flat = epa.reason == Reason::flat;
  Real epa_gap = 0;
  Simplex witness = gjk.simplex;
  if (is_flat)
    reduce_to_closest_face(witness);
  else
    witness = witnesses(epa, epa_gap);

  const bool is_closer = is_flat ? gjk.lower > k_rounding : gjk_gap <= epa_gap;
  const bool is_apart = is_closer && gjk.simplex.size < 4;
  Separation s = is_apart ? in_world(difference, pose_a, pose_b, gjk.simplex, distance,
                                     gjk.normal, gjk_gap)
                          : in_world(difference, pose_a, pose_b, witness, -epa.depth,
                                     -epa.outward, epa_gap);
  s.iterations = gjk.iterations + epa.iterations;
  s.reason = is_apart ? gjk.reason : epa.reason;
  return s;
}

}  // namespace

void epa_start(const MinkowskiDifference& difference, const Simplex& simplex,
               Epa& epa) {
  // Two points, as far from each other as from the axes' directions one finds
  const SupportPoint p = simplex.vertices[0];
  const std::array axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const Farthest q = farthest(difference, simplex, axes,
                              [&](const Vec3& w) { return glm::distance(w, p.w); });
  if (!(q.height > k_rounding)) return finish_flat(difference, epa, {0, 0, 1});

  // A third, away from their line
  const Vec3 e = (q.point.w - p.w) / q.height;
  const Vec3 d = any_perpendicular(e);
  const std::array across{d, glm::cross(e, d)};
  const Farthest r = farthest(difference, simplex, across, [&](const Vec3& w) {
    return glm::length(glm::cross(e, w - p.w));
  });
  if (!(r.height > k_rounding)) return finish_flat(difference, epa, d);

  // A fourth, away from their plane
  const Vec3 n = unit_or_zero(area_normal(p.w, q.point.w, r.point.w));
  const Farthest s = farthest(difference, simplex, std::array{n}, [&](const Vec3& w) {
    return std::abs(glm::dot(n, w - p.w));
  });
  if (!(s.height > k_rounding)) return finish_flat(difference, epa, n);
  make_tetrahedron(epa.polytope, {p, q.point, r.point, s.point});
}

void epa_step(const MinkowskiDifference& difference, Epa& epa) {
  const int index = closest_face(epa.polytope);
  const Real within = epa.depth - k_rounding;
  const Reason at_rest = epa.stuck < within ? Reason::no_progress : Reason::converged;
  epa.lower = epa.stuck;
  if (index < 0) return finish(epa, at_rest);
  PolytopeFace& face = epa.polytope.faces[std::size_t(index)];
  epa.lower = std::min(epa.stuck, face.offset);
  if (face.offset >= within) return finish(epa, at_rest);

  // What is behind the face; nothing, if it is on the difference's boundary
  const SupportPoint far = measure(difference, epa, face.normal, face.vertices);
  if (glm::dot(face.normal, far.w) - face.offset <= k_rounding)
    return finish(epa, at_rest);
  if (epa.polytope.vertex_count == k_polytope_vertices || epa.iterations >= k_epa_limit)
    return finish(epa, Reason::iteration_limit);
  if (has_vertex(epa.polytope, far.w) || !expand(epa.polytope, index, far)) {
    face.final = true;
    epa.stuck = std::min(epa.stuck, face.offset);
  }
}

Separation separation(const Convex& a, const Pose& pose_a, const Convex& b,
                      const Pose& pose_b, GjkCache* cache) {
  const MinkowskiDifference difference = minkowski_difference(a, pose_a, b, pose_b);
  if (!(difference.unit > 0)) return {.reason = Reason::out_of_range};

  // Apart, with a plane between them to prove it
  const Gjk gjk = run_gjk(difference, cache);
  if (cores_meet(gjk) || gjk.reason != Reason::converged)
    return separation_by_epa(difference, gjk, pose_a, pose_b);
  const Real distance = glm::length(gjk.v);
  Separation s =
      in_world(difference, pose_a, pose_b, gjk.simplex, distance, gjk.normal, 0);
  s.iterations = gjk.iterations;
  return s;
}

bool intersect(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b,
               GjkCache* cache) {
  const MinkowskiDifference difference = minkowski_difference(a, pose_a, b, pose_b);
  if (!(difference.unit > 0)) return false;
  const Real radius = (a.radius + b.radius) / difference.unit;
  Gjk gjk = gjk_start(difference, cache);
  while (!gjk.done && gjk.lower <= radius && glm::length(gjk.v) > radius)
    gjk_step(difference, gjk);
  if (cache != nullptr) cache->simplex = gjk.simplex;
  if (cores_meet(gjk) || glm::length(gjk.v) <= radius) return true;
  return gjk.reason != Reason::converged
         && separation_by_epa(difference, gjk, pose_a, pose_b).distance <= 0;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
