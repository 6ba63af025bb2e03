#include "common/graphics/mesh_bytes.hpp"

#include <cstring>

namespace timestep {
namespace {

/// How many elements follow, then the elements as they lie in memory.
template <typename List>
void append(std::string& bytes, const List& list) {
  const std::size_t count = list.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
  bytes.append(reinterpret_cast<const char*>(list.data()),
               count * sizeof(typename List::value_type));
}

/// Takes a list off the front of `bytes`.
template <typename List>
void take(std::string_view& bytes, List& list) {
  std::size_t count = 0;
  std::memcpy(&count, bytes.data(), sizeof(count));
  bytes.remove_prefix(sizeof(count));

  const std::size_t size = count * sizeof(typename List::value_type);
  list.resize(count);
  if (size > 0) std::memcpy(list.data(), bytes.data(), size);
  bytes.remove_prefix(size);
}

}  // namespace

std::string to_bytes(const std::vector<MeshPart>& parts) {
  std::string bytes;
  for (const MeshPart& part : parts) {
    append(bytes, part.mesh.positions);
    append(bytes, part.mesh.normals);
    append(bytes, part.mesh.texture_coordinates);
    append(bytes, part.mesh.triangles);
    append(bytes, std::vector<Color>{part.color});
    append(bytes, part.texture.string());
  }
  return bytes;
}

std::vector<MeshPart> parts_from_bytes(std::string_view bytes) {
  std::vector<MeshPart> parts;
  while (!bytes.empty()) {
    MeshPart& part = parts.emplace_back();
    take(bytes, part.mesh.positions);
    take(bytes, part.mesh.normals);
    take(bytes, part.mesh.texture_coordinates);
    take(bytes, part.mesh.triangles);

    std::vector<Color> color;
    std::string texture;
    take(bytes, color);
    take(bytes, texture);
    part.color = color.at(0);
    part.texture = texture;
  }
  return parts;
}

}  // namespace timestep
