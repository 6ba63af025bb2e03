#include "common/graphics/offscreen_context.hpp"

#include <fmt/format.h>

#include "common/graphics/framebuffer.hpp"
#include "common/graphics/input_error.hpp"

#if __has_include(<epoxy/egl.h>)
#include "common/graphics/egl_context.hpp"
#else
namespace timestep {
namespace {

/// Stands in where there is no EGL: it can only refuse.
struct EglContext {
  EglContext() { throw InputError("no off-screen OpenGL: this system has no EGL"); }
  void make_current() {}
};

}  // namespace
}  // namespace timestep
#endif

namespace timestep {

struct OffscreenContext::State {
  State(glm::ivec2 size, int samples) : framebuffer(size, samples) {}
  ~State() { context.make_current(); }

  EglContext context;
  Framebuffer framebuffer;
};

OffscreenContext::OffscreenContext(int width, int height, int samples)
    : state_(std::make_unique<State>(glm::ivec2(width, height), samples)) {}
OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

void OffscreenContext::begin() {
  state_->context.make_current();
  state_->framebuffer.begin();
}

Image OffscreenContext::read() {
  state_->context.make_current();
  return state_->framebuffer.read();
}

int OffscreenContext::width() const {
  return state_->framebuffer.size().x;
}
int OffscreenContext::height() const {
  return state_->framebuffer.size().y;
}

}  // namespace timestep
