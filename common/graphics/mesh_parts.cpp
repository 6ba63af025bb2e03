#include "common/graphics/mesh_parts.hpp"

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "common/graphics/apart.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/mesh_bytes.hpp"

#ifdef TIMESTEP_HAS_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

namespace timestep {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& fault) {
  throw InputError(fmt::format("mesh {}: {}", file.string(),
                               fault.substr(0, fault.find_first_of("\r\n"))));
}

void require_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse(file, "is a folder");
  if (!std::filesystem::exists(file, ignored)) refuse(file, "there is no such file");
  if (!std::filesystem::is_regular_file(file, ignored)) refuse(file, "is not a file");
  if (std::filesystem::file_size(file, ignored) == 0) refuse(file, "is empty");
}

}  // namespace

#ifdef TIMESTEP_HAS_ASSIMP
namespace {

glm::vec3 from_assimp(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

bool finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void copy_vertices(const aiMesh& from, MeshData& to,
                   const std::filesystem::path& file) {
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    if (!finite(from.mVertices[i])) {
      refuse(file, fmt::format("vertex {} is not finite", i));
    }
    to.positions.push_back(from_assimp(from.mVertices[i]));
    if (from.HasNormals() && finite(from.mNormals[i])) {
      to.normals.push_back(from_assimp(from.mNormals[i]));
    }
    if (from.HasTextureCoords(0)) {
      to.texture_coordinates.emplace_back(from.mTextureCoords[0][i].x,
                                          from.mTextureCoords[0][i].y);
    }
  }
  // Normals are all there or none is, and the graphics card makes its own
  if (to.normals.size() != to.positions.size()) to.normals.clear();
}

void copy_triangles(const aiMesh& from, MeshData& to,
                    const std::filesystem::path& file) {
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (unsigned k = 0; k < 3; ++k) {
      triangle[k] = face.mIndices[k];
      if (triangle[k] >= from.mNumVertices) {
        refuse(file, fmt::format("index {} is out of range, there are {} vertices",
                                 triangle[k], from.mNumVertices));
      }
    }
    to.triangles.push_back(triangle);
  }
}

void copy_material(const aiMaterial& from, MeshPart& to,
                   const std::filesystem::path& file) {
  aiColor4D color;
  if (from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS) {
    to.color = {color.r, color.g, color.b, 1};
  }
  aiString name;
  if (from.GetTexture(aiTextureType_DIFFUSE, 0, &name) == AI_SUCCESS
      && name.C_Str()[0] != '*') {
    to.texture = file.parent_path() / name.C_Str();
  }
}

const aiScene& read(Assimp::Importer& importer, const std::filesystem::path& file) {
  // Only triangles, in the file's own frame
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_SortByPType
                         | aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals
                         | aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    refuse(file, importer.GetErrorString());
  }
  return *scene;
}

std::vector<MeshPart> read_parts(const std::filesystem::path& file) {
  Assimp::Importer importer;
  const aiScene& scene = read(importer, file);

  std::vector<MeshPart> parts;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    MeshPart part;
    copy_vertices(mesh, part.mesh, file);
    copy_triangles(mesh, part.mesh, file);
    if (mesh.mMaterialIndex < scene.mNumMaterials) {
      copy_material(*scene.mMaterials[mesh.mMaterialIndex], part, file);
    }
    if (!part.mesh.triangles.empty()) parts.push_back(std::move(part));
  }
  if (parts.empty()) refuse(file, "has no triangles");
  return parts;
}

}  // namespace

bool can_load_meshes() {
  return true;
}

std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& file) {
  constexpr unsigned k_patience = 30;  // [s]
  require_file(file);

  // A broken file can crash assimp or keep it busy for ever
  const auto read = [&]() -> std::string {
    try {
      return "+" + to_bytes(read_parts(file));
    } catch (const InputError& error) {
      return std::string("-") + error.what();
    }
  };
  const std::optional<std::string> answer = compute_apart(read, k_patience);
  if (!answer) {
    refuse(file,
           fmt::format("is broken: assimp crashes over it or takes more than {} s",
                       k_patience));
  }
  if (answer->front() == '-') throw InputError(answer->substr(1));
  return parts_from_bytes(std::string_view(*answer).substr(1));
}

#else

bool can_load_meshes() {
  return false;
}

std::vector<MeshPart> load_mesh_parts(const std::filesystem::path& file) {
  require_file(file);
  refuse(file, "this build cannot read meshes, it was made without assimp");
}

#endif

}  // namespace timestep
