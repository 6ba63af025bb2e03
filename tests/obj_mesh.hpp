/// @file
/// The meshes of assets/meshes as they are, without assimp: for files of triangles that
/// name their vertices alone.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "common/physics/mesh_mass.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct ObjMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

inline ObjMesh read_obj(const std::string& path) {
  std::ifstream file(path);
  ObjMesh mesh;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    Vec3 p(0);
    if (kind == "v" && words >> p.x >> p.y >> p.z) mesh.vertices.push_back(p);
    if (kind != "f") continue;
    Triangle t{};
    for (std::uint32_t& i : t) {
      std::string corner;
      words >> corner;
      i = std::uint32_t(std::stoul(corner)) - 1;
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
