/// @file
/// A place to draw pictures without a display.
#pragma once

#include <string>

#include "common/graphics/draw_list.hpp"
#include "common/graphics/offscreen_context.hpp"
#include "common/graphics/renderer.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {

/// Pictures of one size. Only one studio may exist at a time.
class Studio {
 public:
  /// Throws InputError if this machine cannot draw off-screen.
  explicit Studio(glm::ivec2 size);

  /// The picture from `pose`, moved back where it is narrower than 16:9, so that what
  /// the scene shows from left to right stays in it. `banner` stands large at the
  /// bottom.
  Image render(const DrawList& list, const CameraPose& pose,
               const std::string& banner = "");

 private:
  void draw_banner(const std::string& banner);

  glm::ivec2 size_;
  OffscreenContext context_;
  ResourceManager resources_;
  Renderer renderer_;
};

}  // namespace timestep
