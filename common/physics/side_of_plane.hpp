/// @file
/// Planes through three points: on which side of one a point is, without an error, and
/// what is upwards. Source: chapter 4; J. R.
/// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates, 1997.
#pragma once

#include <glm/glm.hpp>

#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (4.22) The sign of det(b - a, c - a, p - a): 1 where a, b, c are seen
/// counter-clockwise from p, -1 on the other side, 0 exactly in their plane. Never
/// wrong: where rounding leaves the sign open, the determinant is summed again without
/// rounding. Coordinates must be 0 or within 2^-200 to 2^200, so that no product leaves
/// the range of double.
int side_of_plane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  const glm::dvec3& p);

/// (b - a) x (c - a): up from the plane, as long as twice the triangle's area. Right to
/// a few roundings of itself, however narrow the triangle is and far from the origin.
glm::dvec3 accurate_normal(const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c);

}  // namespace timestep::inline TIMESTEP_PRECISION
