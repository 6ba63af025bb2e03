#include "common/graphics/model.hpp"

namespace timestep {

void Model::add(Mesh mesh, Material material) {
  parts_.emplace_back(std::move(mesh), material);
}

void Model::draw(const glm::mat4& world_from_model) const {
  for (const auto& [mesh, material] : parts_) {
    material.bind();
    material.shader().set("world_from_model", world_from_model);
    mesh.draw();
  }
}

}  // namespace timestep
