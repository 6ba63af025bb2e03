/// @file
/// Where the fountain's droplets start: a nozzle, or the surface of a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "common/graphics/mesh_data.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {

/// n starts within the angle `spread` [rad] around straight up, at `speed` [m/s], from
/// a disc of 5 cm at the origin.
std::vector<exact::Motion> emit_from_nozzle(std::size_t n, double speed, double spread);

/// n starts evenly over the area of a mesh that stands on the ground and is scaled to 2
/// m, along the surface's normals at `speed`.
std::vector<exact::Motion> emit_from_mesh(std::size_t n, double speed,
                                          const MeshData& mesh);

/// The same mesh as it is drawn: centred over the origin, on the ground, 2 m in size.
MeshData stand_on_ground(MeshData mesh);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
