// Opens a window on whatever display there is, draws, moves the camera, closes; twice.
// Prints what went wrong and exits with 1. Run by graphics_window.py under Xvfb.

#include <cstdio>
#include <exception>

#include <imgui.h>

#include "common/graphics/camera.hpp"
#include "common/graphics/renderer.hpp"
#include "common/graphics/window.hpp"

using namespace timestep;

namespace {

/// Whether the window shows the panel and the scene without a fault.
bool run_once() {
  Window window("Timestep", 320, 240, 4);
  ResourceManager resources;
  Renderer renderer(resources, window.handle());
  DrawList list;
  list.title = "A window";
  list.balls.push_back({});
  CameraPose pose;
  for (int frame = 0; frame < 3 && !window.should_close(); ++frame) {
    window.begin_frame();
    pose = window.move(pose);
    const glm::ivec2 size = window.framebuffer_size();
    renderer.draw(list, Camera(pose), size);
    renderer.begin_ui(size);
    ImGui::Begin("Panel");
    ImGui::End();
    renderer.end_ui();
    window.end_frame();
  }
  return window.framebuffer_size() == glm::ivec2(320, 240)
         && Window::display_available();
}

}  // namespace

int main() {
  try {
    if (Window::display_available() && run_once() && run_once()) return 0;
    std::puts("the window is not as it should be");
  } catch (const std::exception& error) {
    std::puts(error.what());
  }
  return 1;
}
