#include "common/graphics/resource_manager.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/mesh_parts.hpp"

namespace timestep {
namespace {

/// The text of a shader: an embedded one of this name, else a file.
std::string shader_text(const std::string& name) {
  if (const std::string_view text = embedded_shader(name); !text.empty()) {
    return std::string(text);
  }
  std::ifstream file(name);
  if (!file) throw InputError(fmt::format("shader {}: there is no such file", name));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Puts the file that the source includes in its place, and keeps the count of lines.
ShaderSource find_shader(const std::string& name) {
  constexpr std::string_view k_include = "#include \"";
  ShaderSource source{name, shader_text(name), {}};
  const std::size_t start = source.text.find(k_include);
  if (start == std::string::npos) return source;

  const std::size_t file = start + k_include.size();
  const std::size_t end = source.text.find('"', file);
  source.included = source.text.substr(file, end - file);
  const std::string before = source.text.substr(0, start);
  const std::size_t rest = std::min(source.text.find('\n', file), source.text.size());
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  source.text =
      fmt::format("{}#line 1 1\n{}#line {} 0{}", before, shader_text(source.included),
                  line + 1, source.text.substr(rest));
  return source;
}

}  // namespace

const Shader& ResourceManager::load_shader(const std::string& vertex,
                                           const std::string& fragment) {
  const Names names{vertex, fragment};
  if (const auto known = shaders_.find(names); known != shaders_.end()) {
    return known->second;
  }
  Shader shader(find_shader(vertex), find_shader(fragment));
  return shaders_.emplace(names, std::move(shader)).first->second;
}

const Texture& ResourceManager::load_texture(const std::filesystem::path& file) {
  const std::string path = find_asset("textures", file).string();
  if (const auto known = textures_.find(path); known != textures_.end()) {
    return known->second;
  }
  return textures_.emplace(path, Texture(load_image(path))).first->second;
}

const Model& ResourceManager::load_model(const std::filesystem::path& file,
                                         const Shader& shader) {
  const std::string path = find_asset("meshes", file).string();
  const std::pair key{path, &shader};
  if (const auto known = models_.find(key); known != models_.end()) {
    return known->second;
  }

  Model model;
  for (const MeshPart& part : load_mesh_parts(path)) {
    const Texture* texture =
        part.texture.empty() ? nullptr : &load_texture(part.texture);
    model.add(Mesh(part.mesh), Material(shader, part.color, texture));
  }
  return models_.emplace(key, std::move(model)).first->second;
}

const Mesh& ResourceManager::mesh(const std::shared_ptr<const MeshData>& data) {
  std::erase_if(meshes_, [](const auto& entry) { return entry.second.data.expired(); });
  const auto known = meshes_.find(data.get());
  if (known != meshes_.end()) return known->second.mesh;
  return meshes_.emplace(data.get(), Uploaded{data, Mesh(*data)}).first->second.mesh;
}

}  // namespace timestep
