/// @file
/// Contact manifolds: where two shapes touch, in up to four points. Source: chapter 4;
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, 1974.
#pragma once

#include <array>
#include <cstdint>

#include "common/physics/convex_hull.hpp"
#include "common/physics/separation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (4.25) A chord along the manifold's normal, from the surface of one shape to that of
/// the other.
struct ContactPoint {
  Vec3 position;  ///< [m] its middle, world
  Real depth;     ///< [m] its length; negative across a gap

  /// The two sides of faces that meet here: the same from frame to frame as long as
  /// they do. 0 for a lone point that has none.
  std::uint64_t feature;
};

/// All contact points of a pair: as many of `points` as `count` says.
struct Manifold {
  Vec3 normal{0, 0, 1};  ///< of length one, from A to B
  std::array<ContactPoint, 4> points;
  int count = 0;
};

/// Where a contact point is on the surface of A, and of B [m].
inline Vec3 on_a(const Manifold& manifold, const ContactPoint& point) {
  return point.position + point.depth / 2 * manifold.normal;
}
inline Vec3 on_b(const Manifold& manifold, const ContactPoint& point) {
  return point.position - point.depth / 2 * manifold.normal;
}

/// A face with more corners than this is clipped as the polygon of some of them, evenly
/// chosen.
inline constexpr int k_face_capacity = 32;

/// The flat part of a shape's surface that faces a direction most, in the world.
struct SupportingFace {
  std::array<Vec3, k_face_capacity> corners;  ///< [m] counter-clockwise from outside
  std::array<std::uint32_t, k_face_capacity>
      sides;                  ///< names of those that start there
  int count = 0;              ///< of corners; 0 if the shape has no faces
  Vec3 normal{0};             ///< of length one, outwards
  bool is_boundless = false;  ///< a plane: one corner, no sides
};

/// Of a box: the face most along the direction. Of a hull: the one of those around its
/// support vertex; none of a cloud without faces. A half-space is all one face.
/// Directions are of the world, of any length but 0.
SupportingFace supporting_face(const Box& box, const Pose& pose, const Vec3& direction);
SupportingFace supporting_face(const ConvexHull& hull, const Pose& pose,
                               const Vec3& direction);
SupportingFace supporting_face(const HullShape& view, const Pose& pose,
                               const Vec3& direction);
SupportingFace supporting_face(const HalfSpace& plane, const Pose& pose,
                               const Vec3& direction);
SupportingFace supporting_face(const Shape& shape, const Pose& pose,
                               const Vec3& direction);

/// Round shapes have none.
template <class Round>
SupportingFace supporting_face(const Round&, const Pose&, const Vec3&) {
  return {};
}

/// The manifold of two shapes of which a query found the separation, from the faces
/// that they turn to each other along its normal.
///
/// Where the shapes are further apart than `margin` [m, not negative] there are no
/// points. Elsewhere, touching and overlapping shapes among them, there is at least
/// one: the deepest has depth = -distance, the others are no further apart than the
/// margin. Both up to rounding: 64 u times the size of the faces.
///
/// Where the normal is within 6 degrees of that of a face, these are the corners of
/// what the faces share, seen along the normal. Of more than four, the deepest is kept
/// with those that make the largest area with it. Near ties, of a hundredth in depth
/// and of a thousandth in area, go to the lower feature, so that they end the same way
/// in each frame. Elsewhere, as where edges cross, or where a shape has no faces, there
/// is one, half way between the witness points.
Manifold contact_manifold(const SupportingFace& a, const SupportingFace& b,
                          const Separation& separation, Real margin = 0);

/// The same of two shapes that are placed: of one kind each, or any `Shape`.
template <class A, class B>
Manifold contact_manifold(const A& a, const Pose& pose_a, const B& b,
                          const Pose& pose_b, const Separation& separation,
                          Real margin = 0) {
  // About A's place, so that it costs no digits to be far away
  const Vec3 at = pose_a.position;
  Separation s = separation;
  s.on_a -= at;
  s.on_b -= at;
  const Pose turned_a{Vec3(0), pose_a.orientation};
  const Pose beside_b{pose_b.position - at, pose_b.orientation};
  Manifold manifold =
      contact_manifold(supporting_face(a, turned_a, s.normal),
                       supporting_face(b, beside_b, -s.normal), s, margin);
  for (std::size_t i = 0; i < std::size_t(manifold.count); ++i)
    manifold.points[i].position += at;
  return manifold;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
