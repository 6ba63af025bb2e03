/// @file
/// Exercise 4.5, challenge: The closest point of a triangle, of slivers too
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// The point of a triangle a, b, c [m] closest to p, its corners and edges included.
/// The triangle may be as thin as it likes, down to a segment or a point; the distance
/// is right to 32 roundings of the largest coordinate.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace timestep
