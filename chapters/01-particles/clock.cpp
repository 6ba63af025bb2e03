// Two clocks: one adds dt at every step, the other counts the steps and multiplies.
#include <cmath>
#include <numbers>

#include "chapters/01-particles/parts.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/rounding.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

class Clock : public Simulation {
 public:
  explicit Clock(const Setup& setup) : setup_(setup) {}

  void step() override {
    ++steps_;
    if (setup_.method == "add")
      clock_ += Real(setup_.dt);
    else
      clock_ = Real(static_cast<double>(steps_) * setup_.dt);
  }

  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return 0; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  static glm::vec3 on_dial(double seconds, double radius);

  Setup setup_;
  Real clock_ = 0;  // what this clock shows [s]
  long long steps_ = 0;
};

std::vector<Metric> Clock::metrics() const {
  const double t = static_cast<double>(steps_) * setup_.dt;
  return {
      {"clock_error", "s", clock_ - t},
      {"clock", "s", clock_},
      {"spacing", "s", spacing(clock_)},
  };
}

// The tip of a hand that goes round once a minute.
glm::vec3 Clock::on_dial(double seconds, double radius) {
  const double angle = 2 * std::numbers::pi * seconds / 60;
  return {radius * std::sin(angle), 2.2 + radius * std::cos(angle), 0};
}

std::vector<BodyState> Clock::bodies() const {
  const glm::dvec3 tip = on_dial(clock_, 1.6);
  return {{.name = "hand", .position = tip}};
}

void Clock::draw(DrawList& list) const {
  const glm::vec3 tip = on_dial(clock_, 1.6);
  list.arrows.push_back(
      {.from = on_dial(0, 0), .to = tip, .color = setup_.style.color});
}

void Clock::draw_reference(DrawList& list) const {
  Polyline rim{.points = {}, .color = k_muted, .width = 3};
  for (int second = 0; second <= 60; ++second) {
    rim.points.push_back(on_dial(second, 1.9));
    const double mark = second % 5 == 0 ? 1.7 : 1.8;
    list.lines.push_back({.points = {on_dial(second, mark), on_dial(second, 1.9)},
                          .color = k_muted,
                          .width = 2});
  }
  list.lines.push_back(rim);
}

}  // namespace

Scene clock_scene() {
  return {
      .name = "clock",
      .summary = "a clock that adds dt loses time; one that counts steps does not",
      .methods = {{"add", "t = t + dt", method_style(0)},
                  {"count", "t = n dt", method_style(1)}},
      .default_methods = {"add", "count"},
      .parameters = {},
      .duration = 3600,
      .camera = {.target = {0.6F, 1.9F, 0}, .distance = 7.5F, .yaw = 0, .pitch = 0.05F},
      .chart_metric = "clock_error",
      .start = [](const Setup& setup) { return std::make_unique<Clock>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
