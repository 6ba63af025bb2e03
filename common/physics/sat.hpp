/// @file
/// The separating axis test: two convex polyhedra are apart if, and only if, they are
/// apart along a face normal of one of them or across an edge of each. Source: chapter
/// 4; thesis, section 2.2; for hulls, D. Gregorius, The separating axis test between
/// convex polyhedra, GDC 2013.
#pragma once

#include <cstdint>

#include "common/physics/convex_hull.hpp"
#include "common/physics/separation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// What an axis comes from.
enum class SatFeature { face_of_a, face_of_b, edges };

/// The axis along which two shapes are furthest apart, or overlap least.
struct SatResult {
  /// Of overlapping shapes: the penetration depth, its normal and witness points, the
  /// one beside a face in that face's plane. Of separated shapes the distance is but a
  /// lower bound, along the best of these axes: the distance itself is for GJK to find.
  Separation separation;
  SatFeature feature = SatFeature::face_of_a;
  std::uint32_t on_a = 0,
                on_b = 0;       ///< a face, or half-edges; of a box an axis: 0 to 2
  int axes = 0;                 ///< that the shapes were projected on
  std::int64_t edge_pairs = 0;  ///< that were looked at for axes
};

/// (4.23) Two boxes: 3 + 3 face normals and 9 directions across an edge of each. A face
/// is preferred to edges that are better by rounding alone.
SatResult sat(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

/// (4.24) Two hulls: all face normals of both, and the direction across each pair of
/// edges that makes a face of their Minkowski difference. The pairs to look at grow
/// with the product of the edge counts. Faces are preferred as above.
SatResult sat(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
              const Pose& pose_b);

}  // namespace timestep::inline TIMESTEP_PRECISION
