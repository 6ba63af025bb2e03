/// @file
/// A mesh file's parts with the colours and images that it gives them.
#pragma once

#include <filesystem>
#include <vector>

#include "common/graphics/draw_list.hpp"

namespace timestep {

/// One mesh of a file, in the file's frame, and how its surface looks.
struct MeshPart {
  MeshData mesh;
  Color color{0.8F, 0.8F, 0.8F, 1};
  std::filesystem::path texture;  ///< empty if none
};

/// Reads a file as `load_mesh` does, with the same errors, its parts kept apart. There
/// is at least one, and each has a triangle.
std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& file);

}  // namespace timestep
