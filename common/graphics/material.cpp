#include "common/graphics/material.hpp"

namespace timestep {

Material::Material(const Shader& shader, Color diffuse, const Texture* texture)
    : shader_(&shader), diffuse_(diffuse), texture_(texture) {}

void Material::bind() const {
  shader_->set("diffuse", diffuse_);
  shader_->set("has_map", texture_ != nullptr ? 1 : 0);
  shader_->set("diffuse_map", 0);
  if (texture_ != nullptr) texture_->bind(0);
}

}  // namespace timestep
