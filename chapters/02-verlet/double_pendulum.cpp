// Two rods, two masses, and chaos: every error grows tenfold every two seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "chapters/02-verlet/double_pendulum_reference.hpp"
#include "chapters/02-verlet/parts.hpp"
#include "chapters/02-verlet/recent_trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/systems.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

using double_precision::chapter_02::ReferencePendulum;

// The reference's tolerance, and the one that tells how far it can be trusted
constexpr double k_tight = 1e-14;
constexpr double k_looser = 1e-13;

using Bobs = std::array<glm::dvec2, 2>;

// From the pivot [m]
Bobs bobs(const ReferencePendulum& p) {
  const auto along = [](double theta) {
    return glm::dvec2(std::sin(theta), -std::cos(theta));
  };
  const glm::dvec2 upper = p.l1 * along(p.theta[0]);
  return {upper, upper + p.l2 * along(p.theta[1])};
}

// [m/s]
Bobs velocities(const ReferencePendulum& p) {
  const auto across = [](double theta) {
    return glm::dvec2(std::cos(theta), std::sin(theta));
  };
  const glm::dvec2 upper = p.l1 * p.omega[0] * across(p.theta[0]);
  return {upper, upper + p.l2 * p.omega[1] * across(p.theta[1])};
}

// Both bobs' [m]
double distance(const ReferencePendulum& a, const ReferencePendulum& b) {
  const Bobs p = bobs(a);
  const Bobs q = bobs(b);
  return std::hypot(glm::distance(p[0], q[0]), glm::distance(p[1], q[1]));
}

// In the picture the rods are two units long together, and the pivot is the origin
glm::vec3 place(const ReferencePendulum& p, const glm::dvec2& bob) {
  return picture({2.0 / (p.l1 + p.l2) * bob, 0});
}

class DoublePendulumRun : public SchemeRun {
 public:
  explicit DoublePendulumRun(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long body_count() const override { return 2; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  ReferencePendulum here() const;
  double energy_error() const;
  void draw_pendulum(DrawList& list, const ReferencePendulum& p,
                     const RecentTrail& trail, const Style& style, float layer) const;

  ReferencePendulum start_, reference_, looser_;
  double reference_time_ = 0;
  double largest_error_ = 0, largest_energy_error_ = 0;
  RecentTrail trail_, reference_trail_;
};

ReferencePendulum pendulum_of(const Setup& setup) {
  const auto value = [&](const char* name) { return setup.parameters.at(name); };
  return {value("m1"),
          value("m2"),
          value("l1"),
          value("l2"),
          value("gravity"),
          {value("theta1"), value("theta2")},
          {value("omega1"), value("omega2")}};
}

// (2.24) The two angles are all the coordinates
Acceleration force_of(const ReferencePendulum& p) {
  const DoublePendulum system{Real(p.m1), Real(p.m2), Real(p.l1), Real(p.l2),
                              Real(p.g)};
  return [system](auto theta, auto omega, Real, auto alpha) {
    double_pendulum(system, theta, omega, alpha);
  };
}

State state_of(const ReferencePendulum& p) {
  return {.x = {Real(p.theta[0]), Real(p.theta[1])},
          .v = {Real(p.omega[0]), Real(p.omega[1])},
          .a = {0, 0}};
}

DoublePendulumRun::DoublePendulumRun(const Setup& setup)
    : SchemeRun(setup, force_of(pendulum_of(setup)), state_of(pendulum_of(setup))),
      start_(pendulum_of(setup)),
      reference_(start_),
      looser_(start_) {}

ReferencePendulum DoublePendulumRun::here() const {
  const State state = now();
  ReferencePendulum p = start_;
  p.theta = {state.x[0], state.x[1]};
  p.omega = {state.v[0], state.v[1]};
  return p;
}

// In units of the energy at the start above rest; where that is none, nothing moves
double DoublePendulumRun::energy_error() const {
  const double scale = energy_above_rest(start_);
  return scale > 0 ? energy_above_rest(here()) / scale - 1 : 0;
}

void DoublePendulumRun::observe() {
  // The reference follows to the same moment
  const double ahead = time() - reference_time_;
  if (ahead > 0) {
    advance(reference_, ahead, k_tight);
    advance(looser_, ahead, k_looser);
    reference_time_ = time();
  }

  largest_error_ = std::max(largest_error_, distance(here(), reference_));
  largest_energy_error_ = std::max(largest_energy_error_, std::abs(energy_error()));
  trail_.add(time(), place(start_, bobs(here())[1]));
  reference_trail_.add(time(), place(start_, bobs(reference_)[1]));
}

std::vector<BodyState> DoublePendulumRun::bodies() const {
  const Bobs x = bobs(here());
  const Bobs v = velocities(here());
  return {
      {.name = "upper bob", .position = {x[0], 0}, .velocity = {v[0], 0}},
      {.name = "lower bob", .position = {x[1], 0}, .velocity = {v[1], 0}},
  };
}

std::vector<Metric> DoublePendulumRun::metrics() const {
  const ReferencePendulum p = here();
  return {
      {"state_error", "m", distance(p, reference_)},
      {"state_error_max", "m", largest_error_},
      {"energy_error", "", energy_error()},
      {"energy_error_max", "", largest_energy_error_},
      {"theta1", "rad", p.theta[0]},
      {"theta2", "rad", p.theta[1]},
      {"theta1_reference", "rad", reference_.theta[0]},
      {"theta2_reference", "rad", reference_.theta[1]},
      {"reference_uncertainty", "m", distance(reference_, looser_)},
  };
}

void DoublePendulumRun::draw_pendulum(DrawList& list, const ReferencePendulum& p,
                                      const RecentTrail& trail, const Style& style,
                                      float layer) const {
  // Where the lower bob was
  list.lines.push_back({.points = trail.points(),
                        .color = style.color,
                        .width = 2.5F,
                        .dash = style.dash,
                        .fade = true});

  // The rods, and the bobs as large as their masses, one method before the other
  const auto [upper, lower] = bobs(p);
  list.lines.push_back({.points = {{0, 0, 0}, place(p, upper), place(p, lower)},
                        .color = style.color,
                        .width = 3,
                        .dash = style.dash});
  const glm::vec3 forward{0, 0, layer * 0.02F};
  const auto radius = [&](double m) {
    return static_cast<float>(0.1 * std::cbrt(2 * m / (p.m1 + p.m2)));
  };
  list.balls.push_back({place(p, upper) + forward, radius(p.m1), style.color});
  list.balls.push_back({place(p, lower) + forward, radius(p.m2), style.color});
  const glm::vec3 front = place(p, lower) + forward + glm::vec3(0, 0, radius(p.m2));
  list.markers.push_back({.position = front, .style = style, .size = 15});
}

void DoublePendulumRun::draw(DrawList& list) const {
  draw_pendulum(list, here(), trail_, setup().style, static_cast<float>(setup().lane));
}

void DoublePendulumRun::draw_reference(DrawList& list) const {
  draw_pendulum(list, reference_, reference_trail_, reference_style(), -1);
  list.balls.push_back({{0, 0, 0}, 0.07F, k_body});
  list.legend.push_back({reference_style(), "reference"});
  list.ground_height = -2.2F;
}

}  // namespace

Scene double_pendulum_scene() {
  constexpr double k_turn = 2 * std::numbers::pi;
  return {
      .name = "double-pendulum",
      .summary = "chaos, and accelerations that depend on the velocity",
      .methods = choices({"explicit_euler", "semi_implicit_euler", "velocity_verlet",
                          "verlet_half", "verlet_predicted", "verlet_implicit",
                          "midpoint", "heun", "rk4", "dopri5", "implicit_euler",
                          "implicit_midpoint", "implicit_trapezoid", k_adaptive}),
      .default_methods = {"semi_implicit_euler", "verlet_predicted", "midpoint", "rk4"},
      .parameters = {{"m1", "kg", "of the upper bob", 1, 1e-6, 1e6},
                     {"m2", "kg", "of the lower bob", 1, 1e-6, 1e6},
                     {"l1", "m", "length of the upper rod", 1, 1e-3, 1e3},
                     {"l2", "m", "length of the lower rod", 1, 1e-3, 1e3},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
                     {"theta1", "rad", "upper rod at the start, from hanging", 2,
                      -k_turn, k_turn},
                     {"theta2", "rad", "lower rod at the start, from hanging", 1,
                      -k_turn, k_turn},
                     {"omega1", "rad/s", "upper rod at the start", 0, -100, 100},
                     {"omega2", "rad/s", "lower rod at the start", 0, -100, 100},
                     tolerance_parameter()},
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.target = {-0.55F, 0, 0}, .distance = 6.2F, .yaw = 0, .pitch = 0.05F},
      .chart_metric = "state_error",
      .chart_logarithmic = true,
      .start =
          [](const Setup& setup) { return std::make_unique<DoublePendulumRun>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
