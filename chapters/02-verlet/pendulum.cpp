// A pendulum at any angle: swinging, turning over, or almost standing on its head.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/02-verlet/parts.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "common/physics/systems.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

class Pendulum : public SchemeRun {
 public:
  explicit Pendulum(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  exact::Coordinate here() const {
    const State state = now();
    return {state.x[0], state.v[0]};
  }
  exact::Coordinate exact_at(double t) const {
    return exact::pendulum(start_, omega0_, t);
  }
  double energy(const exact::Coordinate& c) const;
  double state_error() const;

  // What the scheme itself keeps as its velocity, be it half a step old
  double kept_rate() const { return kept().v[0]; }

  double length_, omega0_;
  exact::Coordinate start_;
  double largest_error_ = 0, largest_energy_error_ = 0;
};

// (2.23) The angle is the only coordinate
Acceleration force_of(const Setup& setup) {
  const Real g = Real(setup.parameters.at("gravity"));
  const Real length = Real(setup.parameters.at("length"));
  return [g, length](auto theta, auto, Real, auto a) {
    a[0] = pendulum(g, length, theta[0]);
  };
}

Pendulum::Pendulum(const Setup& setup)
    : SchemeRun(setup, force_of(setup),
                {.x = {Real(setup.parameters.at("theta"))},
                 .v = {Real(setup.parameters.at("omega"))},
                 .a = {0}}),
      length_(setup.parameters.at("length")),
      omega0_(std::sqrt(setup.parameters.at("gravity") / length_)),
      start_{setup.parameters.at("theta"), setup.parameters.at("omega")} {}

// In units of what lifts the pendulum from hanging to its head: 0 at rest, 1 on top
double Pendulum::energy(const exact::Coordinate& c) const {
  const double rate = c.v / (2 * omega0_);
  return rate * rate + std::pow(std::sin(c.x / 2), 2);
}

// Radians, and radians a second in units of omega0: components alone cross zero
double Pendulum::state_error() const {
  const exact::Coordinate c = here();
  const exact::Coordinate e = exact_at(time());
  return std::hypot(c.x - e.x, (c.v - e.v) / omega0_);
}

void Pendulum::observe() {
  const exact::Coordinate c = here();
  largest_error_ = std::max(largest_error_, state_error());
  largest_energy_error_ =
      std::max(largest_energy_error_, std::abs(energy(c) - energy(start_)));
}

std::vector<BodyState> Pendulum::bodies() const {
  const exact::Coordinate c = here();
  const glm::dvec3 along{std::cos(c.x), std::sin(c.x), 0};
  return {{.name = "bob",
           .position = length_ * glm::dvec3(std::sin(c.x), -std::cos(c.x), 0),
           .velocity = length_ * c.v * along}};
}

std::vector<Metric> Pendulum::metrics() const {
  const exact::Coordinate c = here();
  const exact::Coordinate e = exact_at(time());
  return {
      {"state_error", "rad", state_error()},
      {"state_error_max", "rad", largest_error_},
      {"energy_error", "", energy(c) - energy(start_)},
      {"energy_error_max", "", largest_energy_error_},
      {"theta", "rad", c.x},
      {"omega", "rad/s", c.v},
      {"theta_exact", "rad", e.x},
      {"omega_exact", "rad/s", e.v},
      {"period", "s", exact::pendulum_period(start_, omega0_)},
      {"period_ratio", "",
       exact::pendulum_period(start_, omega0_) * omega0_ / (2 * std::numbers::pi)},
      {"omega_dt", "", omega0_ * dt()},
      {"kept_rate_error", "rad/s", std::abs(kept_rate() - e.v)},
  };
}

// The pivot stands at (0, 2), rods are two units long
glm::vec3 bob(double theta) {
  return {2 * std::sin(theta), 2 - 2 * std::cos(theta), 0};
}

void draw_pendulum(DrawList& list, double theta, const Style& style) {
  const glm::vec3 pivot{0, 2, 0};
  list.lines.push_back({.points = {pivot, bob(theta)},
                        .color = style.color,
                        .width = 3,
                        .dash = style.dash});
  list.balls.push_back({bob(theta), 0.14F, style.color});
  list.markers.push_back({.position = bob(theta), .style = style, .size = 15});
}

void Pendulum::draw(DrawList& list) const {
  draw_pendulum(list, here().x, setup().style);
}

void Pendulum::draw_reference(DrawList& list) const {
  draw_pendulum(list, exact_at(time()).x, reference_style());
  list.balls.push_back({{0, 2, 0}, 0.07F, k_body});
  list.legend.push_back({reference_style(), "exact"});
  list.ground_height = -0.6F;
}

}  // namespace

Scene pendulum_scene() {
  constexpr double k_turn = 2 * std::numbers::pi;
  return {
      .name = "pendulum",
      .summary = "a rigid pendulum at any angle, beside its elliptic functions",
      .methods = all_choices(),
      .default_methods = {"semi_implicit_euler", "velocity_verlet", "midpoint", "rk4"},
      .parameters = {{"length", "m", "of the rod", 1, 1e-3, 1e3},
                     {"gravity", "m/s²", "downwards", 9.81, 1e-3, 1e3},
                     {"theta", "rad", "at the start, from hanging", 3, -k_turn, k_turn},
                     {"omega", "rad/s", "at the start", 0, -1e3, 1e3},
                     tolerance_parameter()},
      .dt = 1.0 / 20,
      .duration = 12,
      .camera = {.target = {0.9F, 1.9F, 0}, .distance = 8, .yaw = 0, .pitch = 0.05F},
      .chart_metric = "energy_error",
      .start = [](const Setup& setup) { return std::make_unique<Pendulum>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
