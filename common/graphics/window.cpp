#include "common/graphics/window.hpp"

#include <epoxy/gl.h>
// After epoxy, which replaces the system's OpenGL header
#include <utility>

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "common/graphics/camera.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

/// Starts GLFW, once for the program; false if there is no display.
bool start_glfw() {
  return glfwInit() != 0;
}

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

/// What GLFW last complained about.
std::string glfw_fault() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

GLFWwindow* open_window(const std::string& title, int width, int height, int samples) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, samples);
  return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

bool imgui_has_mouse() {
  return ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantCaptureMouse;
}

}  // namespace

struct Window::State {
  std::unique_ptr<GLFWwindow, WindowDeleter> window;
  glm::vec2 mouse{0};
  bool dragging = false;
  float wheel = 0;
};

Window::Window(const std::string& title, int width, int height, int samples)
    : state_(std::make_unique<State>()) {
  if (!start_glfw()) {
    throw InputError(fmt::format("no window: there is no display ({})", glfw_fault()));
  }
  state_->window.reset(open_window(title, width, height, samples));
  if (!state_->window) throw InputError(fmt::format("no window: {}", glfw_fault()));

  glfwMakeContextCurrent(handle());
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(handle(), state_.get());
  glfwSetScrollCallback(handle(), [](GLFWwindow* window, double, double steps) {
    static_cast<State*>(glfwGetWindowUserPointer(window))->wheel +=
        static_cast<float>(steps);
  });
}

Window::~Window() = default;
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;

bool Window::display_available() {
  return start_glfw();
}

bool Window::should_close() const {
  return glfwWindowShouldClose(handle()) != 0;
}

GLFWwindow* Window::handle() const {
  return state_->window.get();
}

void Window::begin_frame() {
  glfwPollEvents();
  const glm::ivec2 size = framebuffer_size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
}

void Window::end_frame() {
  glfwSwapBuffers(handle());
}

glm::ivec2 Window::framebuffer_size() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(handle(), &size.x, &size.y);
  return size;
}

CameraPose Window::move(const CameraPose& pose) {
  // What happened since the last call
  glm::dvec2 place{0};
  glm::ivec2 size{0};
  glfwGetCursorPos(handle(), &place.x, &place.y);
  glfwGetWindowSize(handle(), &size.x, &size.y);
  const glm::vec2 drag = glm::vec2(place) - state_->mouse;
  const float wheel = std::exchange(state_->wheel, 0.0F);
  const bool left = glfwGetMouseButton(handle(), GLFW_MOUSE_BUTTON_LEFT) != 0;
  const bool right = glfwGetMouseButton(handle(), GLFW_MOUSE_BUTTON_RIGHT) != 0;
  const bool shift = glfwGetKey(handle(), GLFW_KEY_LEFT_SHIFT) != 0
                     || glfwGetKey(handle(), GLFW_KEY_RIGHT_SHIFT) != 0;

  // A drag that began on a panel stays the panel's
  const bool ours = !imgui_has_mouse() && size.y > 0;
  const bool was_dragging = state_->dragging;
  state_->dragging = (left || right) && ours;
  state_->mouse = place;
  if (!ours) return pose;

  const auto height = static_cast<float>(size.y);
  CameraPose moved = zoom(pose, wheel);
  if (!was_dragging || !state_->dragging) return moved;
  return right || shift ? pan(moved, drag, height) : orbit(moved, drag, height);
}

}  // namespace timestep
