/// @file
/// The same question put to libccd, by its two algorithms. Source: chapter 4; D. Fišer,
/// libccd 2.1; for MPR, G. Snethen, XenoCollide, Game Programming Gems 7, 2008.
#pragma once

#include "common/physics/separation.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

// Lengths go to libccd in a unit about as large as the pair, since its tolerances are
// absolute, and in its own type, double as most systems build it. It allocates memory.
//
// Of shapes that overlap, depth, normal and witness points are what it says: the error
// is its tolerance, which it may miss. Of shapes that are apart it says no more than
// that: `lower_bound`, with the least positive distance that there is, the normal from
// origin to origin, and the witness points between those. `iteration_limit` is the
// best so far of what it would not end by itself, and `no_answer` what is no number.

/// Its GJK, with EPA for the depth.
Separation libccd_epa(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b);

/// Its Minkowski portal refinement, whose depth is along one good direction, and not
/// always the least.
Separation libccd_mpr(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b);

/// Any but half-spaces, which have no support points.
bool libccd_takes(const Shape& a, const Shape& b);

}  // namespace timestep::inline TIMESTEP_PRECISION
