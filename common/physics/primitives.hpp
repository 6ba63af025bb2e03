/// @file
/// Pairs of primitive shapes whose separation has a closed form. A sphere or a capsule
/// is all points within its radius of a core, which leaves the distance of two points,
/// two segments, or a point and a solid. Source: chapter 4; C. Ericson, Real-Time
/// Collision Detection, 2005, chapter 5.
#pragma once

#include <optional>

#include "common/physics/separation.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

// Each right to a few roundings of the pair's size, which `error` bounds. Where several
// normals serve, the one that is named.

/// (4.5) Coincident centres: along z.
Separation sphere_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b,
                         const Pose& pose_b);

/// (4.6) A centre inside the box goes out through the nearest face: in a tie the first
/// of x, y, z, on its positive side.
Separation sphere_box(const Sphere& a, const Pose& pose_a, const Box& b,
                      const Pose& pose_b);

/// A centre on the axis goes out at right angles to it.
Separation sphere_capsule(const Sphere& a, const Pose& pose_a, const Capsule& b,
                          const Pose& pose_b);

/// (4.7) Crossing axes part along their common perpendicular, axes on one line at
/// right angles to it. Of parallel ones that pass each other the witness points are
/// some pair.
Separation capsule_capsule(const Capsule& a, const Pose& pose_a, const Capsule& b,
                           const Pose& pose_b);

/// (4.8) A centre inside goes out through the side or the nearer flat face, whichever
/// is nearer; in a tie the side, in the other the upper face; from the axis along x.
Separation sphere_cylinder(const Sphere& a, const Pose& pose_a, const Cylinder& b,
                           const Pose& pose_b);

/// (4.9) Any shape by its support point against the normal. Two half-spaces overlap
/// without end: their distance is -infinity, the reason `unbounded`.
Separation any_half_space(const Shape& a, const Pose& pose_a, const HalfSpace& b,
                          const Pose& pose_b);

/// Any of these pairs, in either order; nothing for the others.
std::optional<Separation> closed_form(const Shape& a, const Pose& pose_a,
                                      const Shape& b, const Pose& pose_b);

}  // namespace timestep::inline TIMESTEP_PRECISION
