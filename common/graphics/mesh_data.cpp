#include "common/graphics/mesh_data.hpp"

#include "common/graphics/mesh_parts.hpp"

namespace timestep {
namespace {

/// Appends `from` to `onto`; a part without normals or texture coordinates leaves the
/// whole without.
void join(MeshData& onto, const MeshData& from) {
  const auto shift = static_cast<std::uint32_t>(onto.positions.size());
  const bool first = onto.positions.empty();
  const auto append = [&](auto& whole, const auto& part) {
    if (part.empty() || (!first && whole.empty())) {
      whole.clear();
    } else {
      whole.insert(whole.end(), part.begin(), part.end());
    }
  };
  append(onto.normals, from.normals);
  append(onto.texture_coordinates, from.texture_coordinates);
  onto.positions.insert(onto.positions.end(), from.positions.begin(),
                        from.positions.end());
  for (const auto& [a, b, c] : from.triangles) {
    onto.triangles.push_back({a + shift, b + shift, c + shift});
  }
}

}  // namespace

MeshData load_mesh(const std::filesystem::path& file) {
  MeshData whole;
  for (const MeshPart& part : load_mesh_parts(file)) join(whole, part.mesh);
  return whole;
}

}  // namespace timestep
