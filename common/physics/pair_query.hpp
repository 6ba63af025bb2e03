/// @file
/// One question about any two shapes, and several ways to answer it. Source: chapter 4.
#pragma once

#include <span>
#include <string_view>

#include "common/physics/separation.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// The signed distance of any two shapes: by GJK and EPA, of half-spaces by (4.9).
Separation separation(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b);

/// A way to find the separation of two shapes in the world.
struct PairMethod {
  std::string_view name, summary;

  /// Of a pair that it does not take: `no_answer`.
  Separation (*query)(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b);

  /// Whether it has an answer for such a pair at all.
  bool (*takes)(const Shape& a, const Shape& b);
};

/// gjk_epa, closed_form, sat, libccd_epa, libccd_mpr. The last three find no distance
/// of shapes that are apart: see `lower_bound`.
std::span<const PairMethod> pair_methods();

}  // namespace timestep::inline TIMESTEP_PRECISION
