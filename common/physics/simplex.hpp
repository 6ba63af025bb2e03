/// @file
/// The point of a simplex (a point, segment, triangle or tetrahedron) that is closest
/// to the origin. Source: chapter 4; M. Montanari, N. Petrinic, E. Barbieri, Improving
/// the GJK algorithm for faster and more reliable distance queries between convex
/// objects, ACM Transactions on Graphics 36(3), 2017 (signed volumes).
#pragma once

#include <array>

#include "common/physics/minkowski.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (4.12) The normal of a triangle, twice as long as its area, counter-clockwise. Of
/// one that is thin, whose plane rounding would tilt, in the next wider type than Real.
Vec3 area_normal(const Vec3& p, const Vec3& q, const Vec3& r);

/// The closest point is the sum of weight w over its vertices.
struct Simplex {
  std::array<SupportPoint, 4> vertices;
  std::array<Real, 4> weights;  ///< positive, of sum 1
  int size = 0;
};

/// The point of a simplex that is closest to the origin: the sum of a weight each over
/// the vertices, 0 for those that are not needed. All are positive where a tetrahedron
/// holds the origin.
struct ClosestPoint {
  Vec3 point;
  std::array<Real, 4> weights{};
};

/// (4.13) The closest point and its weights.
///
/// Weights are ratios of lengths, areas or volumes, each with its sign; where one is
/// not positive, the closest point is on a part without that vertex. Any vertices will
/// do, coincident, collinear and coplanar ones as well.
ClosestPoint closest_to_origin(const Simplex& simplex);

/// The same for a tetrahedron that is flat, up to rounding: on one of its faces.
ClosestPoint closest_on_face(const Simplex& simplex);

/// Keeps the vertices that have weight.
void keep(Simplex& simplex, const ClosestPoint& closest);

/// (4.13) Reduces a simplex to the vertex, edge or face that the point closest to the
/// origin is on, sets its weights and returns that point. A tetrahedron around the
/// origin stays whole, and the point is the origin.
Vec3 reduce_to_closest(Simplex& simplex);

/// The same of a flat tetrahedron.
Vec3 reduce_to_closest_face(Simplex& simplex);

/// The point of A or of B that the weights stand for, in its own frame [m].
Vec3 witness_on_a(const Simplex& simplex);
Vec3 witness_on_b(const Simplex& simplex);

}  // namespace timestep::inline TIMESTEP_PRECISION
