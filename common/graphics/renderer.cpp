#include "common/graphics/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "common/graphics/annotations.hpp"
#include "common/graphics/ball_pass.hpp"
#include "common/graphics/chart.hpp"
#include "common/graphics/framebuffer.hpp"
#include "common/graphics/ground_pass.hpp"
#include "common/graphics/overlay.hpp"
#include "common/graphics/sheet.hpp"
#include "common/graphics/surface_pass.hpp"

namespace timestep {
namespace {

constexpr int k_shadow_side = 2048;

Frame frame_for(const DrawList& list, const Camera& camera, glm::ivec2 size) {
  Frame frame;
  frame.size = size;
  frame.pose = camera.pose();
  frame.eye = camera.position();
  frame.clip_from_world =
      camera.projection(frame.size.x / frame.size.y) * camera.view();
  frame.scale = std::min(frame.size.y / 720, frame.size.x / 960);
  frame.pixel = 2 * std::tan(frame.pose.vertical_fov / 2) / frame.size.y;
  frame.light = light_for(list, frame.pose, k_shadow_side);
  return frame;
}

/// A mistake of ours, not of the user: OpenGL refused something during this frame.
void require_no_error() {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::logic_error(fmt::format("OpenGL error {:#x} in a frame", error));
  }
}

}  // namespace

struct Renderer::State {
  State(ResourceManager& resources, GLFWwindow* shown_in)
      : surfaces(resources),
        balls(resources),
        ground(resources),
        lines(resources),
        markers(resources),
        sheet(resources),
        shadows(k_shadow_side),
        window(shown_in) {}

  void draw_shadow_map(const DrawList& list, const Frame& frame);
  void draw_scene(const DrawList& list, const Frame& frame);
  void draw_sheet(const DrawList& list, const Frame& frame);

  SurfacePass surfaces;
  BallPass balls;
  GroundPass ground;
  LineBatch lines;
  SymbolBatch markers;
  Sheet sheet;
  ShadowMap shadows;
  GLFWwindow* window;
  std::optional<Overlay> overlay;  ///< from the first panel on
};

Renderer::Renderer(ResourceManager& resources, GLFWwindow* window)
    : state_(std::make_unique<State>(resources, window)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const DrawList& list, const Camera& camera, glm::ivec2 size) {
  if (size.x < 1 || size.y < 1) return;
  const Frame frame = frame_for(list, camera, size);
  GLint picture = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &picture);

  state_->draw_shadow_map(list, frame);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(picture));
  glViewport(0, 0, size.x, size.y);
  state_->draw_scene(list, frame);
  state_->draw_sheet(list, frame);
  require_no_error();
}

void Renderer::State::draw_shadow_map(const DrawList& list, const Frame& frame) {
  surfaces.prepare(list);
  balls.prepare(list, frame);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  shadows.begin();
  surfaces.draw_shadows(frame);
  balls.draw_shadows(frame);
}

void Renderer::State::draw_scene(const DrawList& list, const Frame& frame) {
  shadows.bind(1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_MULTISAMPLE);

  // What hides what is behind it
  ground.draw_background(frame);
  surfaces.draw(frame, true);
  balls.draw(frame);

  // What hides nothing: the lines on the ground stay whole
  glDepthMask(GL_FALSE);
  if (list.ground_height) {
    ground.draw_ground(frame, *list.ground_height);
    if (frame.light.half_size.x > 0) ground.draw_shadow(frame, *list.ground_height);
  }
  surfaces.draw(frame, false);

  lines.clear();
  for (const Polyline& line : list.lines) {
    lines.add(line.points, {line.color, line.width * frame.scale, line.dash, line.fade},
              frame);
  }
  for (const Arrow& arrow : list.arrows) lines.add_arrow(arrow, frame);
  lines.draw(frame);

  markers.clear();
  for (const Marker& marker : list.markers) markers.add(marker, frame);
  markers.draw(frame);
  glDepthMask(GL_TRUE);
}

void Renderer::State::draw_sheet(const DrawList& list, const Frame& frame) {
  sheet.clear();
  add_labels(list.labels, sheet, frame);
  add_title(list, sheet, frame);
  add_legend(list.legend, sheet, frame);
  add_charts(list, sheet, frame);
  glDisable(GL_DEPTH_TEST);
  sheet.draw(frame);
  glEnable(GL_DEPTH_TEST);
}

void Renderer::begin_ui(glm::ivec2 size, float scale) {
  if (!state_->overlay) state_->overlay.emplace(state_->window);
  state_->overlay->begin(size, scale);
}

void Renderer::end_ui() {
  state_->overlay->end();
  require_no_error();
}

}  // namespace timestep
