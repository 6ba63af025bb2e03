/// @file
/// The unit shapes of the draw list as triangle meshes.
#pragma once

#include "common/graphics/draw_list.hpp"

namespace timestep {

/// The shape's mesh, with normals; front faces run counter-clockwise.
MeshData unit_mesh(ShapeKind kind);

}  // namespace timestep
