// What a slow frame does to a simulation: fixed, variable and semi-fixed time stepping
// of the same spring. One step of this scene is one tick of the wall clock.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chapters/01-particles/parts.hpp"
#include "common/chapter/fixed_step.hpp"
#include "common/chapter/random.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/euler.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

class FrameDrops : public Simulation {
 public:
  explicit FrameDrops(const Setup& setup);

  void step() override {
    ++ticks_;
    while (frame_start_ + frame_time_ <= wall_clock()) {
      simulate_frame(frame_time_);
      frame_start_ += frame_time_;
      frame_time_ = next_frame_time();
    }
  }

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return steps_; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  void simulate_frame(double frame_time);
  void integrate(double dt);
  double next_frame_time();
  double wall_clock() const { return static_cast<double>(ticks_) * setup_.dt; }
  exact::Coordinate exact_at(double t) const;
  double energy() const;
  glm::vec3 graph_point(double t, double x) const;

  Setup setup_;
  double stiffness_, omega_, slow_frame_, slow_every_, jitter_, max_step_;
  Acceleration acceleration_;
  FixedStep fixed_;
  Random random_{1};
  State mass_on_spring_ = particles(1);
  long long ticks_ = 0, steps_ = 0, frames_ = 0, slow_frames_ = 0;
  double frame_start_ = 0, frame_time_ = 0;  // of the frame that is being shown [s]
  double time_ = 0;                          // that the simulation has reached [s]
  double largest_error_ = 0;
  Trail shown_;  // what the player saw: a point for each frame
};

FrameDrops::FrameDrops(const Setup& setup)
    : setup_(setup),
      stiffness_(setup.parameters.at("stiffness")),
      omega_(std::sqrt(stiffness_)),
      slow_frame_(setup.parameters.at("slow_frame")),
      slow_every_(setup.parameters.at("slow_every")),
      jitter_(setup.parameters.at("jitter")),
      max_step_(setup.parameters.at("max_step")) {
  // One tick of the clock shows every frame that it holds, so it must not hold too many
  constexpr double k_longest_tick = 60;  // [s]
  if (setup.dt > k_longest_tick)
    throw InputError(
        fmt::format("--dt {:g}: scene frame-drops takes steps of up to {} s", setup.dt,
                    k_longest_tick));

  fixed_.dt = setup.dt;
  fixed_.max_steps_per_frame = static_cast<int>(setup.parameters.at("max_steps"));
  frame_time_ = next_frame_time();

  // A mass of 1 kg on a spring, stretched by 1 m
  put(mass_on_spring_.x, 0, Vec3(1, 0, 0));
  acceleration_ = [k = Real(stiffness_)](auto x, auto, Real, auto a) {
    put(a, 0, newton(spring(k, at(x, 0), Vec3(0)), Real(1)));
  };
}

// One displayed frame, by each of the three ways to spend its time.
void FrameDrops::simulate_frame(double frame_time) {
  ++frames_;
  if (setup_.method == "variable") {
    integrate(frame_time);
  } else if (setup_.method == "semi_fixed") {
    const double pieces = std::ceil(frame_time / max_step_);
    for (int i = 0; i < static_cast<int>(pieces); ++i) integrate(frame_time / pieces);
  } else {
    const int steps = fixed_.advance(frame_time);
    for (int i = 0; i < steps; ++i) integrate(setup_.dt);
  }
  shown_.add(graph_point(frame_start_ + frame_time, mass_on_spring_.x[0]));
}

void FrameDrops::integrate(double dt) {
  semi_implicit_euler(mass_on_spring_, acceleration_, Real(time_), Real(dt));
  ++steps_;

  // Whole steps are counted, not added up: only variable steps must be summed
  time_ = setup_.method == "fixed" ? static_cast<double>(steps_) * dt : time_ + dt;
}

// Frames of 1/60 s, more or less, and a slow one each time `slow_every` has passed.
double FrameDrops::next_frame_time() {
  if (frame_start_ >= slow_every_ * static_cast<double>(slow_frames_ + 1)) {
    ++slow_frames_;
    return slow_frame_;
  }
  return (1 + jitter_ * random_.uniform(-1, 1)) / 60;
}

exact::Coordinate FrameDrops::exact_at(double t) const {
  return exact::oscillator({1, 0}, omega_, 0, t);
}

double FrameDrops::energy() const {
  const double x = mass_on_spring_.x[0];
  const double v = mass_on_spring_.v[0];
  return (v * v + stiffness_ * x * x) / 2;
}

void FrameDrops::observe() {
  const double error = std::abs(mass_on_spring_.x[0] - exact_at(time_).x);
  largest_error_ = std::max(largest_error_, error);
}

std::vector<BodyState> FrameDrops::bodies() const {
  return {{.name = "mass",
           .position = wide(at(mass_on_spring_.x, 0)),
           .velocity = wide(at(mass_on_spring_.v, 0))}};
}

std::vector<Metric> FrameDrops::metrics() const {
  const double x = mass_on_spring_.x[0];
  return {
      {"energy_ratio", "", energy() / (stiffness_ / 2)},
      {"energy_error", "", energy() / (stiffness_ / 2) - 1},
      {"position_error", "m", std::abs(x - exact_at(time_).x)},
      {"position_error_max", "m", largest_error_},
      {"simulated_time", "s", time_},
      {"dropped_time", "s", fixed_.dropped},
      {"frames", "", static_cast<double>(frames_)},
      {"slow_frames", "", static_cast<double>(slow_frames_)},
      {"integration_steps", "", static_cast<double>(steps_)},
  };
}

// The wall clock runs to the right, the mass swings up and down; what leaves the
// picture stays at its edge.
glm::vec3 FrameDrops::graph_point(double t, double x) const {
  const double right = 12 * t / setup_.duration - 6;
  return {right, 3.2 + std::clamp(x, -2.4, 2.4), 0};
}

void FrameDrops::draw(DrawList& list) const {
  const std::vector<glm::vec3> shown = shown_.points();
  list.lines.push_back({.points = shown, .color = setup_.style.color, .width = 2.5F});
  for (const glm::vec3& point : shown)
    list.balls.push_back({point, 0.05F, setup_.style.color});
  if (!shown.empty()) list.balls.push_back({shown.back(), 0.14F, setup_.style.color});
}

void FrameDrops::draw_reference(DrawList& list) const {
  constexpr int k_pieces = 600;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= k_pieces; ++i) {
    const double t = setup_.duration * i / k_pieces;
    path.push_back(graph_point(t, exact_at(t).x));
  }
  list.lines.push_back(
      {.points = path, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.legend.push_back({reference_style(), "exact"});
  list.labels.push_back(
      {.position = graph_point(0, 2), .text = "position over time", .color = k_muted});
}

}  // namespace

Scene frame_drops_scene() {
  return {
      .name = "frame-drops",
      .summary = "a slow frame every second: fixed, variable and semi-fixed steps",
      .methods = {{"fixed", "whole steps of dt; the rest waits", method_style(1)},
                  {"variable", "one step as long as the frame", method_style(0)},
                  {"semi_fixed", "the frame in equal pieces of at most max_step",
                   method_style(2)}},
      .default_methods = {"fixed", "variable", "semi_fixed"},
      .parameters = {{"stiffness", "N/m", "of the spring, on 1 kg", 100, 1e-6, 1e6},
                     {"slow_frame", "s", "how long a slow frame takes", 0.25, 1e-3, 10},
                     {"slow_every", "s", "from one slow frame to the next", 1, 0.1,
                      1e6},
                     {"jitter", "", "share by which other frames vary", 0.2, 0, 0.9},
                     {"max_step", "s", "for semi_fixed", 1.0 / 30, 1e-4, 1},
                     {"max_steps", "", "in a frame, for fixed", 30, 1, 1000, true}},
      .duration = 4,
      .camera = {.target = {0, 2.1F, 0}, .distance = 12.5F, .yaw = 0, .pitch = 0.08F},
      .chart_metric = "energy_ratio",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<FrameDrops>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
