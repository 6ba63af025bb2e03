/// @file
/// The Minkowski difference of two convex shapes: all differences b - a of a point of B
/// and a point of A. It holds the origin exactly if the shapes meet, and the origin's
/// distance from its boundary is theirs. Source: chapter 4.
#pragma once

#include <limits>

#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A point of the difference, in A's frame [units], and the two that it comes from,
/// each in its own shape's frame [m]. Of a hull also the vertex: there the search for
/// the next support point in much the same direction starts.
struct SupportPoint {
  Vec3 w, a, b;
  std::uint32_t vertex_a, vertex_b;
};

/// (4.10) Two cores in A's frame, in a unit of length (a power of two, so that scaling
/// rounds nothing) in which all their points are within 1 of A's origin, or B's of 1.
/// So one bound on rounding serves all sizes, and squares neither overflow nor vanish.
struct MinkowskiDifference {
  Convex a, b;
  Mat3 a_from_b;  ///< turns
  Vec3 offset;    ///< of B's origin from A's [units]
  Real unit;      ///< [m]
  Real scale;     ///< 1 / unit
};

/// What rounding may do to a point of a difference and to the planes through them
/// [units]: eight roundings for each of a, b, and their difference, with numbers up
/// to 1.
constexpr Real k_rounding = 16 * std::numeric_limits<Real>::epsilon();

/// `unit` is 0 if a number is not finite or the shapes are too far apart for Real.
MinkowskiDifference minkowski_difference(const Convex& a, const Pose& pose_a,
                                         const Convex& b, const Pose& pose_b);

/// Where the difference of two points a and b [m] is, each in its own shape's frame.
Vec3 difference_at(const MinkowskiDifference& difference, const Vec3& a, const Vec3& b);

/// (4.11) The point of B - A with the least dot(direction, w): what of B reaches
/// farthest back against the direction, less what of A reaches farthest forward.
SupportPoint support(const MinkowskiDifference& difference, const Vec3& direction,
                     const SupportPoint& near = {});

/// The same in place: next to what is read of it at once, a copy would have to wait.
void find_support(const MinkowskiDifference& difference, const Vec3& direction,
                  const SupportPoint& near, SupportPoint& point);

}  // namespace timestep::inline TIMESTEP_PRECISION
