/// @file
/// A triangle mesh in ordinary memory, and how to read one from a file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

namespace timestep {

/// Triangles over shared vertices. `normals` is empty or has one unit vector a vertex,
/// `texture_coordinates` is empty or has one pair a vertex.
struct MeshData {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> texture_coordinates;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Whether this build can read mesh files at all (it was built with assimp).
bool can_load_meshes();

/// Reads an OBJ or glTF file (or another format that assimp knows), all its parts
/// joined in the file's own frame. Throws InputError if the file is missing, broken,
/// without triangles, with an index out of range or a vertex that is not finite, or if
/// this build has no assimp.
MeshData load_mesh(const std::filesystem::path& file);

}  // namespace timestep
