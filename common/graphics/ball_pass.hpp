/// @file
/// Draws very many balls. One that is large on the picture is a square on which the
/// ball is found by casting a ray; a small one is a point, which is many times cheaper.
#pragma once

#include <vector>

#include "common/graphics/frame.hpp"
#include "common/graphics/quads.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// The draw list's balls. `prepare` comes first, once a frame.
class BallPass {
 public:
  explicit BallPass(ResourceManager& resources);

  void prepare(const DrawList& list, const Frame& frame);
  void draw_shadows(const Frame& frame) const;
  void draw(const Frame& frame) const;

 private:
  const Shader &square_, &square_shadow_, &point_, &point_shadow_;
  Quads squares_, points_;
  std::vector<Ball> large_, small_;
};

}  // namespace timestep
