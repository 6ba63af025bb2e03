#include "common/chapter/window_app.hpp"

#define GLFW_INCLUDE_NONE
#include <chrono>
#include <memory>
#include <utility>

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "common/chapter/panel.hpp"
#include "common/chapter/picture.hpp"
#include "common/chapter/session.hpp"
#include "common/graphics/renderer.hpp"
#include "common/graphics/resource_manager.hpp"
#include "common/graphics/window.hpp"

namespace timestep {
namespace {

/// A key that counts once when it goes down.
class Key {
 public:
  explicit Key(int code) : code_(code) {}

  bool pressed(GLFWwindow* window) {
    const bool down = glfwGetKey(window, code_) == GLFW_PRESS;
    const bool was_down = std::exchange(down_, down);
    return down && !was_down && !ImGui::GetIO().WantTextInput;
  }

 private:
  int code_ = 0;
  bool down_ = false;
};

struct Keys {
  Key pause{GLFW_KEY_SPACE}, step{GLFW_KEY_PERIOD}, back{GLFW_KEY_COMMA},
      restart{GLFW_KEY_R};
};

/// Seconds since the last call.
double frame_time(std::chrono::steady_clock::time_point& last) {
  const auto now = std::chrono::steady_clock::now();
  return std::chrono::duration<double>(now - std::exchange(last, now)).count();
}

void draw_picture(Renderer& renderer, Session& session, const Controls& controls,
                  const CameraPose& pose, glm::ivec2 size) {
  if (session.lanes().empty()) return;
  DrawList list = session.picture();
  add_words(list, session.plan(), session.lanes(), session.time());
  add_chart(list, session.log(), controls.metric,
            session.plan().scene->chart_logarithmic
                && controls.metric == session.plan().scene->chart_metric);
  renderer.draw(list, Camera(pose), size);
}

void take_keys(Keys& keys, GLFWwindow* window, Wishes& wishes) {
  wishes.pause |= keys.pause.pressed(window);
  wishes.step |= keys.step.pressed(window);
  wishes.back |= keys.back.pressed(window);
  wishes.restart |= keys.restart.pressed(window);
}

/// Does what the user wants, on a fresh session if anything was changed.
void obey(const Wishes& wishes, Controls& controls, std::unique_ptr<Session>& session) {
  const bool again = wishes.pause && session->ended();
  if (wishes.pause && !again) controls.paused = !controls.paused;
  if (wishes.restart || again) {
    session = std::make_unique<Session>(*controls.chapter, choice_of(controls));
  }
  if (wishes.step || wishes.back) controls.paused = true;
  if (wishes.step) session->step_once();
  if (wishes.back) session->step_back();
}

}  // namespace

void run_window(const Chapter& chapter, const Options& options) {
  // What the command line asks for must be right; only what the panel asks for later is
  // refused in the panel
  Controls controls = controls_for(make_plan(chapter, options.choice));
  Window window(chapter.title, options.size.x, options.size.y);
  ResourceManager resources;
  Renderer renderer(resources, window.handle());
  auto session = std::make_unique<Session>(chapter, choice_of(controls));

  Keys keys;
  CameraPose usual = usual_camera(session->plan(), session->lanes());
  CameraPose pose = usual;
  auto last_frame = std::chrono::steady_clock::now();
  for (int frame = 0; !window.should_close(); ++frame) {
    if (options.window_frames && frame == *options.window_frames) break;
    if (!session->lanes().empty()) {
      const CameraPose asked_for = usual_camera(session->plan(), session->lanes());
      if (std::exchange(usual, asked_for) != asked_for) pose = asked_for;
    }

    window.begin_frame();
    const double seconds = frame_time(last_frame);
    if (!controls.paused) session->advance(seconds, controls.speed);

    const glm::ivec2 size = window.framebuffer_size();
    pose = window.move(pose);
    if (size.x == 0 || size.y == 0) {
      window.end_frame();
      continue;
    }
    draw_picture(renderer, *session, controls, pose, size);
    renderer.begin_ui(size);
    Wishes wishes = draw_panel(controls, *session);
    renderer.end_ui();
    window.end_frame();
    take_keys(keys, window.handle(), wishes);
    obey(wishes, controls, session);
  }
}

}  // namespace timestep
