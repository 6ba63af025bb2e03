/// @file
/// A window on the screen, and the mouse over it.
#pragma once

#include <memory>
#include <string>

#include <glm/glm.hpp>

#include "common/graphics/draw_list.hpp"

struct GLFWwindow;

namespace timestep {

/// A window with OpenGL 3.3 core, current in the thread that made it. To be used from
/// the main thread only.
class Window {
 public:
  /// Throws InputError if there is no display or it has no OpenGL 3.3. `samples` are
  /// asked for; the driver may give fewer.
  Window(const std::string& title, int width, int height, int samples = 8);
  ~Window();
  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;

  /// Whether a window could be opened; prints nothing.
  static bool display_available();

  bool should_close() const;

  /// Takes in what the user did, binds the window's framebuffer and clears it.
  void begin_frame();

  /// Shows what was drawn; waits for the display's next refresh.
  void end_frame();

  /// In pixels; zero while the window is iconified.
  glm::ivec2 framebuffer_size() const;

  /// The pose after what the mouse did since the last call: drag turns, right drag or
  /// shift and drag moves, the wheel zooms. Nothing while Dear ImGui wants the mouse.
  CameraPose move(const CameraPose& pose);

  /// For Renderer, so that Dear ImGui gets mouse and keyboard. Belongs to the window.
  GLFWwindow* handle() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace timestep
