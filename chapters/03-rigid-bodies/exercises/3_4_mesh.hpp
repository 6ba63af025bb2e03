/// @file
/// Exercise 3.4, challenge: A solid from its triangles
#pragma once

#include <span>

#include "common/physics/mesh_mass.hpp"

namespace timestep {

/// Volume [m³] of the tetrahedron over the origin and a triangle a, b, c [m]. Negative
/// if the triangle goes clockwise as seen from the side where the origin is not.
Real signed_volume(const Vec3& a, const Vec3& b, const Vec3& c);

/// Mass, centre of mass and inertia tensor about it of what a closed mesh encloses, at
/// an even density [kg/m³]. Its triangles go counter-clockwise as seen from outside. It
/// may be far from the origin [m].
MassProperties solid(Real density, std::span<const Vec3> vertices,
                     std::span<const Triangle> triangles);

}  // namespace timestep
