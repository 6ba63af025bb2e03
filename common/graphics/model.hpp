/// @file
/// Meshes with their materials: what one file of a modelling program describes.
#pragma once

#include <utility>
#include <vector>

#include "common/graphics/material.hpp"
#include "common/graphics/mesh.hpp"

namespace timestep {

/// One or several meshes, each with its material, drawn together.
class Model {
 public:
  /// Adds a mesh and how its surface looks.
  void add(Mesh mesh, Material material);

  /// Draws every part with the uniform `world_from_model` set.
  void draw(const glm::mat4& world_from_model) const;

 private:
  std::vector<std::pair<Mesh, Material>> parts_;
};

}  // namespace timestep
