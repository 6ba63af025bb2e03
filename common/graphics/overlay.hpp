/// @file
/// Dear ImGui with or without a window.
#pragma once

#include <memory>

#include <glm/glm.hpp>

struct GLFWwindow;
struct ImGuiContext;

namespace timestep {

/// Owns the Dear ImGui context and its OpenGL backend. Writes no settings file.
class Overlay {
 public:
  explicit Overlay(GLFWwindow* window);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Starts a frame of `size` pixels, text and controls `scale` times their size.
  void begin(glm::ivec2 size, float scale);

  /// Ends it and draws it.
  void end();

 private:
  void rescale(float scale);

  struct ContextDeleter {
    void operator()(ImGuiContext* context) const;
  };

  GLFWwindow* window_;
  std::unique_ptr<ImGuiContext, ContextDeleter> context_;
  float scale_ = 0;
};

}  // namespace timestep
