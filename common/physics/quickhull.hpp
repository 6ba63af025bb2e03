/// @file
/// Quickhull: the triangles around a point cloud. Source: chapter 4; C. B. Barber, D.
/// P. Dobkin, H. Huhdanpaa, The quickhull algorithm for convex hulls, 1996.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/physics/mesh_mass.hpp"
#include "common/physics/side_of_plane.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A closed surface of triangles around all points: no point is above any of them, and
/// that is exact. Neighbours may lie in one plane, and a vertex within an edge.
struct TriangleHull {
  std::vector<glm::dvec3> points;    ///< all, times the power of two that brings the
                                     ///< largest coordinate into 1 to 2
  std::vector<Triangle> triangles;   ///< indices into the points, seen from outside
  std::vector<Triangle> neighbours;  ///< the triangles beyond the sides that start at
                                     ///< the vertices in the same places
  double rounding = 0;  ///< what a coordinate may be off, in units of `points`: u times
                        ///< the largest one, u the unit round-off of Real
  double thickness = 0;  ///< height of a large tetrahedron between the points
  std::string fault;     ///< empty if there is a hull; see `convex_hull`
};

TriangleHull quickhull(std::span<const Vec3> points);

}  // namespace timestep::inline TIMESTEP_PRECISION
