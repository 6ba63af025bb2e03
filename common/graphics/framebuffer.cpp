#include "common/graphics/framebuffer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

void require_complete() {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw InputError(
        fmt::format("no off-screen OpenGL: framebuffer status {:#x}", status));
  }
}

void make_storage(GLuint buffer, GLenum format, int samples, glm::ivec2 size) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
}

void attach(GLenum slot, GLuint buffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, buffer);
}

}  // namespace

Framebuffer::Framebuffer(glm::ivec2 size, int samples) : size_(size) {
  GLint most_samples = 0, largest = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (size.x < 1 || size.y < 1 || size.x > largest || size.y > largest) {
    throw InputError(
        fmt::format("no off-screen OpenGL: a picture of {} by {} pixels; "
                    "sides from 1 to {} are possible",
                    size.x, size.y, largest));
  }
  samples = std::clamp(samples, 0, most_samples);

  make_storage(color_.id(), GL_RGBA8, samples, size);
  make_storage(depth_.id(), GL_DEPTH_COMPONENT24, samples, size);
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
  attach(GL_COLOR_ATTACHMENT0, color_.id());
  attach(GL_DEPTH_ATTACHMENT, depth_.id());
  require_complete();

  make_storage(resolved_color_.id(), GL_RGBA8, 0, size);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  attach(GL_COLOR_ATTACHMENT0, resolved_color_.id());
  require_complete();
}

void Framebuffer::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
  glViewport(0, 0, size_.x, size_.y);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
}

Image Framebuffer::read() const {
  // Average the samples into the plain buffer
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);

  Image image{size_.x, size_.y, {}};
  const auto row = static_cast<std::size_t>(size_.x) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(size_.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());

  // OpenGL's rows start at the bottom
  auto top = image.rgba.begin();
  auto bottom = image.rgba.end();
  for (int i = 0; i < size_.y / 2; ++i) {
    bottom -= static_cast<std::ptrdiff_t>(row);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    top += static_cast<std::ptrdiff_t>(row);
  }
  return image;
}

ShadowMap::ShadowMap(int side) : side_(side) {
  glBindTexture(GL_TEXTURE_2D, depth_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0,
               GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  const auto set = [](GLenum name, GLenum value) {
    glTexParameteri(GL_TEXTURE_2D, name, static_cast<GLint>(value));
  };
  set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  // What lies outside is lit
  const float far_away[] = {1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far_away);

  GLint previous = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &previous);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                         depth_.id(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  require_complete();
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(previous));
}

void ShadowMap::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, side_, side_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, depth_.id());
}

}  // namespace timestep
