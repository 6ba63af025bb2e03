/// @file
/// Convex shapes, each by its support function: the point farthest in a direction. All
/// lengths in m, in the shape's own frame, the axis along z, about the origin as in
/// mass_properties.hpp. Source: chapter 4; G. van den Bergen, Collision Detection in
/// Interactive 3D Environments, 2003, section 4.3.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "common/physics/pose.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct Sphere {
  Real radius;
};

struct Box {
  Vec3 half_extents;
};

struct Ellipsoid {
  Vec3 semi_axes;
};

/// `height` is that of the cylinder between the two half balls.
struct Capsule {
  Real radius, height;
};

struct Cylinder {
  Real radius, height;
};

/// Its base is at z = 0, its tip at z = height.
struct Cone {
  Real radius, height;
};

/// All points with dot(normal, point) <= offset; the normal is of length one.
struct HalfSpace {
  Vec3 normal;
  Real offset;
};

struct ConvexHull;

/// A view of a polyhedron's vertices, to outlive the query. With `neighbours` (those of
/// vertex i from first_neighbour[i] up to first_neighbour[i + 1]) supports of large
/// hulls climb from vertex to vertex; without, they look at each. Vertices far from the
/// origin cost the digits that their coordinates have in common: better to give them
/// from a point of the shape, and that point as position.
struct HullShape {
  std::span<const Vec3> vertices;  ///< at least one
  std::span<const std::uint32_t> first_neighbour{}, neighbours{};
  std::span<const std::uint32_t> starts{};  ///< by direction_cell; may be left out
  Real volume = 0;                          ///< [m³]
  Real reach = 0;                           ///< of the vertex farthest from the origin
  const ConvexHull* hull = nullptr;         ///< whose view it is, if that has faces
};

/// The view of vertices without neighbours; also of a point, a segment or a triangle.
HullShape hull_shape(std::span<const Vec3> vertices);

using Shape =
    std::variant<Sphere, Box, Ellipsoid, Capsule, Cylinder, Cone, HalfSpace, HullShape>;

// (4.2) A point of the shape farthest in the direction, whose length does not matter (a
// zero direction finds some point of the shape). In a tie: of a box the corner with the
// positive coordinates, of a capsule the upper ball, of a cylinder or cone the middle
// of the flat face, of a cone's tip and rim the tip, of a hull the first vertex in the
// list.

Vec3 support(const Sphere& sphere, const Vec3& direction);
Vec3 support(const Box& box, const Vec3& direction);
Vec3 support(const Ellipsoid& ellipsoid, const Vec3& direction);
Vec3 support(const Capsule& capsule, const Vec3& direction);
Vec3 support(const Cylinder& cylinder, const Vec3& direction);
Vec3 support(const Cone& cone, const Vec3& direction);
Vec3 support(const HullShape& hull, const Vec3& direction);

/// The length of a vector, without overflow on the way; NaN if a coordinate is not
/// finite, which hypot may overlook.
Real length_of(const Vec3& v);

/// The direction of a vector as long as 1, however long it is; zero of zero.
Vec3 unit_or_zero(const Vec3& v);

/// A unit vector at right angles to a unit vector, and to the axis that it is least
/// along.
Vec3 any_perpendicular(const Vec3& unit);

/// Directions by their cell in a grid across a cube around the origin, so many along
/// each of its edges, of which those of its surface are in use.
inline constexpr std::size_t k_cells = 6;
std::size_t direction_cell(const Vec3& direction);
Vec3 middle_of_cell(std::size_t cell);

/// (4.3) The index of a hull's support vertex. With neighbours it climbs from `start`,
/// or from the hull's own start for such directions if that is higher, uphill along the
/// edges: on a convex hull no vertex but the highest has none higher.
std::uint32_t support_vertex(const HullShape& hull, const Vec3& direction,
                             std::uint32_t start);

/// (4.4) A shape as GJK and EPA see it: a core, of which they know the support function
/// alone, and the radius of a ball that is swept over it. A sphere's core is a point, a
/// capsule's a segment; all others are their own core. Refers to the shape.
struct Convex {
  const void* shape;
  /// `hint` is where a hull starts to climb, and is left where it arrived.
  Vec3 (*core_support)(const void* shape, const Vec3& direction, std::uint32_t& hint);
  Real radius;  ///< [m]
  Real reach;   ///< no point of the core is farther from the origin than this [m]
};

/// Any shape but a half-space, which has no support point: that one is its origin.
Convex convex(const Shape& shape);

/// The smallest box along the world's axes, up to a few roundings.
struct Bounds {
  Vec3 low, high;
};

/// Of a half-space: everything.
Bounds bounds(const Shape& shape, const Pose& pose);

/// [m³]
Real volume(const Shape& shape);

}  // namespace timestep::inline TIMESTEP_PRECISION
