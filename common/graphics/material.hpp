/// @file
/// What a surface looks like: the numbers that a shader is given before a mesh is
/// drawn.
#pragma once

#include "common/graphics/draw_list.hpp"
#include "common/graphics/shader.hpp"
#include "common/graphics/texture.hpp"

namespace timestep {

/// Colour, perhaps with a texture, and the shader that draws it. Shader and texture
/// belong to the resource manager.
class Material {
 public:
  explicit Material(const Shader& shader, Color diffuse = {0.8F, 0.8F, 0.8F, 1},
                    const Texture* texture = nullptr);

  const Shader& shader() const { return *shader_; }

  /// Binds the shader and sets its uniforms `diffuse`, `diffuse_map` and `has_map`.
  void bind() const;

 private:
  const Shader* shader_;
  Color diffuse_;
  const Texture* texture_;
};

}  // namespace timestep
