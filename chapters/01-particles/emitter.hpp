/// @file
/// Where the fountain's droplets start: jets, or the surface of a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "common/graphics/mesh_data.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {

/// n starts from a jet that rises straight up and a ring of twelve, 0.3 m around it,
/// that lean outwards by `lean` [rad]; at 0.97 to 1 times `speed` [m/s].
std::vector<exact::Motion> emit_from_jets(std::size_t n, double speed, double lean);

/// n starts evenly over the area of a mesh that stands on the ground and is scaled to 2
/// m, along the surface's normals at `speed`.
std::vector<exact::Motion> emit_from_mesh(std::size_t n, double speed,
                                          const MeshData& mesh);

/// The same mesh as it is drawn: centred over the origin, on the ground, 2 m in size.
MeshData stand_on_ground(MeshData mesh);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
