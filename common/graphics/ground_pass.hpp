/// @file
/// The calm ground behind everything: sky, and a grid that fades into it.
#pragma once

#include "common/graphics/frame.hpp"
#include "common/graphics/quads.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// Sky and ground. The grid's lines are powers of ten of a metre apart, chosen for the
/// camera's distance; each tenth line is stronger.
class GroundPass {
 public:
  explicit GroundPass(ResourceManager& resources);

  void draw_background(const Frame& frame) const;
  void draw_ground(const Frame& frame, float height) const;

  /// Darkens the ground where the shadow map says so.
  void draw_shadow(const Frame& frame, float height) const;

 private:
  const Shader& background_;
  const Shader& ground_;
  const Shader& shadow_;
  Quads square_;
};

}  // namespace timestep
