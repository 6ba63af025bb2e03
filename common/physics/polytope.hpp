/// @file
/// A convex polytope of triangles that grows vertex by vertex, as EPA does it inside
/// the Minkowski difference. Source: chapter 4; C. Barber, D. Dobkin, H. Huhdanpaa, The
/// quickhull algorithm for convex hulls, ACM Transactions on Mathematical Software
/// 22(4), 1996.
#pragma once

#include <array>
#include <cstdint>

#include "common/physics/minkowski.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

constexpr int k_polytope_vertices = 256;
constexpr int k_polytope_faces = 2 * k_polytope_vertices;

/// A triangle of the polytope, counter-clockwise seen from outside.
struct PolytopeFace {
  std::array<std::int16_t, 3> vertices;
  std::array<std::int16_t, 3> neighbours;  ///< [i]: beyond the edge from vertex i
  bool visible;                            ///< from the new vertex, while one is added
  bool final;   ///< not to be searched behind, or no longer part of the polytope
  Vec3 normal;  ///< unit, outward; zero if the face has no area
  Real offset;  ///< of its plane from the origin, negative if that is in front of it
};

/// Lengths in the difference's units. Euler's formula leaves V vertices 2 V - 4 faces.
struct Polytope {
  std::array<SupportPoint, k_polytope_vertices> vertices;
  std::array<PolytopeFace, k_polytope_faces> faces;
  int vertex_count = 0, face_count = 0;
};

/// Over four points that are not in one plane, in any order.
void make_tetrahedron(Polytope& polytope, const std::array<SupportPoint, 4>& points);

/// The face whose plane is closest to the origin, or behind it the most, of those that
/// are not final; -1 if all are.
int closest_face(const Polytope& polytope);

/// Whether one of its vertices is at this point.
bool has_vertex(const Polytope& polytope, const Vec3& w);

/// (4.17) The hull of the polytope and a point in front of a face, for which there must
/// be room: all faces that the point sees go, and a fan of triangles closes the hole.
/// False, with the polytope as it was, where rounding leaves no such hull.
bool expand(Polytope& polytope, int face, const SupportPoint& point);

}  // namespace timestep::inline TIMESTEP_PRECISION
