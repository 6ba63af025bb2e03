/// @file
/// OpenGL without a display: an EGL context with no surface, drawing into a framebuffer
/// of its own.
#pragma once

#include <memory>

#include "common/graphics/image.hpp"

namespace timestep {

/// OpenGL 3.3 core on a graphics card if there is one, else in software. Current in the
/// thread that made it, until another context is made current.
class OffscreenContext {
 public:
  /// A picture of `width` by `height` pixels with up to `samples` samples a pixel, as
  /// many as the driver has. Throws InputError ("no off-screen OpenGL: …") if this
  /// machine cannot.
  OffscreenContext(int width, int height, int samples = 8);
  ~OffscreenContext();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;

  /// Makes the context current, binds and clears its framebuffer, sets the viewport.
  void begin();

  /// What was drawn since `begin`.
  Image read();

  int width() const;
  int height() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace timestep
