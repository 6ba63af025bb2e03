/// @file
/// Draws a draw list: surfaces with light and shadow, lines, symbols, text and charts.
#pragma once

#include <memory>

#include <glm/glm.hpp>

#include "common/graphics/camera.hpp"
#include "common/graphics/draw_list.hpp"
#include "common/graphics/resource_manager.hpp"

struct GLFWwindow;

namespace timestep {

/// One renderer for a context; the context must be current at every call and outlive
/// it, as must the resource manager.
class Renderer {
 public:
  /// With a window, Dear ImGui gets its mouse and keyboard; without one, `begin_ui` and
  /// `end_ui` work all the same and nobody presses the buttons.
  explicit Renderer(ResourceManager& resources, GLFWwindow* window = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws the whole list, text and charts included, into the framebuffer that is
  /// bound, whose size is `size` pixels.
  void draw(const DrawList& list, const Camera& camera, glm::ivec2 size);

  /// Starts a Dear ImGui frame of `size` pixels; text and controls are `scale` times as
  /// large as in a picture 720 pixels high. The caller's ImGui calls come next.
  void begin_ui(glm::ivec2 size, float scale = 1);

  /// Ends the frame that `begin_ui` started and draws it over the picture.
  void end_ui();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace timestep
