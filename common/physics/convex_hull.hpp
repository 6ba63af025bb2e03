/// @file
/// Convex hulls of point clouds: vertices, faces with as many sides as they have, and
/// the edges between them. Source: chapter 4.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/physics/mesh_mass.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// One side of a face, counter-clockwise as seen from outside. Its twin is the same
/// edge as a side of the neighbouring face, and runs the other way.
struct HalfEdge {
  std::uint32_t origin;  ///< the vertex where it starts
  std::uint32_t twin, next;
  std::uint32_t face;
};

/// All points x with dot(normal, x) = offset.
struct Plane {
  Vec3 normal;  ///< of length one, outwards
  Real offset;  ///< [m] from the origin
};

/// A convex polyhedron in its own frame, lengths in m. Every vertex is a corner of at
/// least three faces; V - E + F = 2.
struct ConvexHull {
  std::vector<Vec3> vertices;

  /// A plane for each face. No vertex is above, up to rounding.
  std::vector<Plane> planes;

  /// Face by face, two for each edge: face f has those from face_start[f] up to, not
  /// including, face_start[f + 1].
  std::vector<HalfEdge> half_edges;
  std::vector<std::uint32_t> face_start;

  /// Vertex v has the neighbours from first_neighbour[v] up to, not including,
  /// first_neighbour[v + 1], around it in order.
  std::vector<std::uint32_t> neighbours, first_neighbour;
  std::vector<std::uint32_t> vertex_edge;  ///< a half-edge that starts at each vertex
  std::vector<std::uint32_t> starts;  ///< the support vertex amid each direction_cell

  Real volume = 0;  ///< [m³]
  Real reach = 0;   ///< distance of the furthest vertex from the origin
};

/// A hull, or why there is none.
struct HullResult {
  ConvexHull hull;
  std::string fault;  ///< a short phrase, empty if there is a hull
};

/// The convex hull of points [m], by quickhull. Its vertices are in the order of the
/// points. Fault: the first of "no points"; "too many points" (2^31 or more); "point N
/// is not finite"; "all points coincide"; "all points are on a line"; "all points are
/// in a plane".
///
/// A coordinate counts as known to a rounding u of the largest one, L. So a cloud of at
/// most 8 u L in width is flat, and triangles within 16 u L of one plane are one face:
/// a turned box has six. If the cloud itself is thin, only those within 1/64 of its
/// thickness are. A vertex that this leaves with two faces is left out. All points are
/// within 32 u L of the hull. What is inside and what is not is decided exactly, so no
/// cloud is too hard. Far from the origin L is large: move the cloud first.
HullResult convex_hull(std::span<const Vec3> points);

/// What support functions need of a hull, which must outlive the view where it is.
HullShape hull_shape(const ConvexHull& hull);

/// The faces cut into triangles: a mesh, for `mesh_mass` and `surface_area`.
std::vector<Triangle> hull_triangles(const ConvexHull& hull);

}  // namespace timestep::inline TIMESTEP_PRECISION
