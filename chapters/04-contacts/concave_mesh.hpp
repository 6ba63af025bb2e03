/// @file
/// A mesh file as a concave body: checked, and moved to its middle.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "common/graphics/mesh_data.hpp"
#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

/// Lengths in m, about the middle of its bounds.
struct ConcaveMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::vector<Vec3>> pieces;  ///< vertices that triangles join, each
  std::shared_ptr<const MeshData> shown;  ///< in the same frame
  Vec3 half_extents{0};
  Real volume = 0;  ///< [m³]
};

/// Reads a mesh that fills a solid; a file that is not there is looked for among the
/// assets' meshes. Throws InputError, in one line that names the file and the fault, as
/// `load_mesh` does, for any `mesh_fault`, and for a mesh so small or large that
/// its volume leaves the range of Real.
ConcaveMesh load_concave(const std::filesystem::path& file);

/// How far a point is from the mesh [m], negative inside: from each triangle, one by
/// one.
double distance_to_mesh(const ConcaveMesh& mesh, const Vec3& point);

/// The hull of each piece: what an author has put together of convex ones has them as
/// parts.
std::vector<ConvexHull> hulls_of_pieces(const ConcaveMesh& mesh);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
