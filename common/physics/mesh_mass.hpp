/// @file
/// Triangle meshes as solid bodies: what is wrong with one, and the mass properties of
/// the volume that a sound one encloses. Source: chapter 3; D. Eberly, Polyhedral mass
/// properties (revisited), 2002.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/physics/mass_properties.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Three indices into a list of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// What keeps a mesh from being a solid, in a short phrase; empty if nothing does. The
/// first of: no triangles; a vertex [m] that is not finite; an index out of range;
/// triangles without area; boundary edges; edges with more than two triangles;
/// neighbours of opposite winding; no volume; a negative one (the mesh is inside out).
///
/// Vertices at exactly the same place count as one, as files repeat those along seams
/// of their textures. Several closed parts are fine, and so is a cavity, whose walls
/// are wound the other way: only the whole volume has a sign to be right or wrong. That
/// no two triangles cut each other is not checked.
std::string mesh_fault(std::span<const Vec3> vertices,
                       std::span<const Triangle> triangles);

/// The same triangles wound the other way: the mesh inside out.
std::vector<Triangle> flipped(std::span<const Triangle> triangles);

/// [m³], negative if the mesh is inside out. Of a mesh with nothing else wrong.
Real mesh_volume(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// [m²]
Real surface_area(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// (3.10) The mass properties of what a mesh without fault encloses, at an even density
/// [kg/m³], in the mesh's frame. In the next wider type than Real, from the middle of
/// the mesh: exact to the last rounding but for bodies so thin that it takes that
/// type's digits to tell their sides apart, however far from the origin they are.
MassProperties mesh_mass(Real density, std::span<const Vec3> vertices,
                         std::span<const Triangle> triangles);

}  // namespace timestep::inline TIMESTEP_PRECISION
