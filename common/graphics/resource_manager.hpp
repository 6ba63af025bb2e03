/// @file
/// Loads shaders, images and meshes, owns them, and gives the same one for the same
/// file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "common/graphics/mesh.hpp"
#include "common/graphics/model.hpp"
#include "common/graphics/shader.hpp"
#include "common/graphics/texture.hpp"

namespace timestep {

/// What it returns lives as long as the manager. Needs a current OpenGL context, from
/// its first load to its end. Every fault of a file throws InputError in one line.
class ResourceManager {
 public:
  /// Shaders by the file names in `assets/shaders/`, or by path.
  const Shader& load_shader(const std::string& vertex, const std::string& fragment);

  /// An image by its name in `assets/textures/`, or by path.
  const Texture& load_texture(const std::filesystem::path& file);

  /// A mesh file by its name in `assets/meshes/`, or by path, with the materials that
  /// the file describes, drawn by `shader`.
  const Model& load_model(const std::filesystem::path& file, const Shader& shader);

  /// The mesh on the graphics card for a mesh in memory. It is given back at a later
  /// call once nobody else holds the data.
  const Mesh& mesh(const std::shared_ptr<const MeshData>& data);

 private:
  struct Uploaded {
    std::weak_ptr<const MeshData> data;
    Mesh mesh;
  };
  using Names = std::pair<std::string, std::string>;

  std::map<Names, Shader> shaders_;
  std::map<std::string, Texture> textures_;
  std::map<std::pair<std::string, const Shader*>, Model> models_;
  std::map<const MeshData*, Uploaded> meshes_;
};

/// The file itself if it is there, else the one of this name under `assets/<kind>/`.
/// The folder of assets is $TIMESTEP_ASSETS, else where the build found it, else beside
/// or above the executable. If there is none, the path is returned as it was given.
std::filesystem::path find_asset(const std::string& kind,
                                 const std::filesystem::path& file);

}  // namespace timestep
