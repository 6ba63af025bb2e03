// A mass on a spring: what each method does to its energy, and what drag and damping
// cost.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chapters/01-particles/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

class Spring : public Simulation {
 public:
  explicit Spring(const Setup& setup);

  void step() override {
    const Real t = Real(time());
    method_.step(mass_on_spring_, acceleration_, t, Real(setup_.dt));

    // (1.10) Damping, the thesis's Listing 3: a share of the velocity is lost
    for (Real& v : mass_on_spring_.v) v *= damping_;
    ++steps_;
  }

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return steps_ * method_.evaluations; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  double time() const { return static_cast<double>(steps_) * setup_.dt; }
  exact::Coordinate exact_at(double t) const;
  exact::Coordinate now() const { return {mass_on_spring_.x[0], mass_on_spring_.v[0]}; }
  double energy(const exact::Coordinate& c) const;
  glm::vec3 phase_point(const exact::Coordinate& c) const;

  Setup setup_;
  NamedIntegrator method_;
  Acceleration acceleration_;
  double mass_, stiffness_, omega_, gamma_;
  exact::Coordinate start_;
  Real damping_;
  State mass_on_spring_ = particles(1);
  long long steps_ = 0;
  double largest_error_ = 0;
  Trail phase_trail_;
};

Spring::Spring(const Setup& setup)
    : setup_(setup),
      method_(euler_method(setup.method)),
      mass_(setup.parameters.at("mass")),
      stiffness_(setup.parameters.at("stiffness")),
      omega_(std::sqrt(stiffness_ / mass_)),
      start_{setup.parameters.at("stretch"), setup.parameters.at("speed")},
      damping_(damping_factor(Real(setup.parameters.at("damping")), Real(setup.dt))) {
  // Drag and damping together are one linear drag: gamma = (c/m - ln damping) / 2
  const double c = setup.parameters.at("linear_drag");
  gamma_ = (c / mass_ - std::log(setup.parameters.at("damping"))) / 2;
  put(mass_on_spring_.x, 0, Vec3(Real(start_.x), 0, 0));
  put(mass_on_spring_.v, 0, Vec3(Real(start_.v), 0, 0));

  // (1.1), (1.7), (1.8) Newton's law with the spring and linear drag
  acceleration_ = [k = Real(stiffness_), c = Real(c), inverse_mass = Real(1 / mass_)](
                      auto x, auto v, Real, auto a) {
    const Vec3 force = spring(k, at(x, 0), Vec3(0)) + linear_drag(c, at(v, 0));
    put(a, 0, newton(force, inverse_mass));
  };
}

exact::Coordinate Spring::exact_at(double t) const {
  return exact::oscillator(start_, omega_, gamma_, t);
}

double Spring::energy(const exact::Coordinate& c) const {
  return (mass_ * c.v * c.v + stiffness_ * c.x * c.x) / 2;
}

void Spring::observe() {
  largest_error_ = std::max(largest_error_, std::abs(now().x - exact_at(time()).x));
  phase_trail_.add(phase_point(now()));
}

std::vector<BodyState> Spring::bodies() const {
  return {{.name = "mass",
           .position = wide(at(mass_on_spring_.x, 0)),
           .velocity = wide(at(mass_on_spring_.v, 0))}};
}

std::vector<Metric> Spring::metrics() const {
  const exact::Coordinate e = exact_at(time());
  return {
      {"energy_ratio", "", energy(now()) / energy(start_)},
      {"energy_error", "", (energy(now()) - energy(e)) / energy(start_)},
      {"energy", "J", energy(now())},
      {"energy_exact", "J", energy(e)},
      {"position_error", "m", std::abs(now().x - e.x)},
      {"position_error_max", "m", largest_error_},
      {"omega_dt", "", omega_ * setup_.dt},
      {"x", "m", now().x},
      {"v", "m/s", now().v},
      {"x_exact", "m", e.x},
  };
}

// The phase portrait stands upright behind the springs, in units of the amplitude at
// the start: position to the right, velocity over omega upwards. Exact undamped motion:
// a circle.
glm::vec3 Spring::phase_point(const exact::Coordinate& c) const {
  const double amplitude = std::sqrt(2 * energy(start_) / stiffness_);
  const glm::dvec2 p = glm::dvec2(c.x, c.v / omega_) / amplitude;
  return {2.6 + 1.15 * p.x, 2.6 + 1.15 * p.y, -1.2};
}

void Spring::draw(DrawList& list) const {
  const auto lane = static_cast<float>(setup_.lane);
  const auto x = static_cast<float>(now().x / std::hypot(start_.x, start_.v / omega_));
  const glm::vec3 wall{-3.6F, 0.35F, 1.1F * lane - 1.1F};
  const glm::vec3 center{-1.4F + x, wall.y, wall.z};

  // The coil: eleven turns between the wall and the mass
  Polyline coil{.points = {}, .color = k_muted, .width = 2.5F};
  constexpr int k_pieces = 220;
  for (int i = 0; i <= k_pieces; ++i) {
    const float s = static_cast<float>(i) / k_pieces;
    const float turn = 2 * 3.14159265F * 11 * s;
    const glm::vec3 around{0, 0.16F * std::cos(turn), 0.16F * std::sin(turn)};
    coil.points.push_back(glm::mix(wall, center - glm::vec3(0.3F, 0, 0), s) + around);
  }
  list.lines.push_back(coil);

  const glm::mat4 place = glm::translate(glm::mat4(1), center);
  list.shapes.push_back(
      {ShapeKind::box, glm::scale(place, glm::vec3(0.3F)), setup_.style.color});

  // The phase portrait: a spiral tells the energy
  list.lines.push_back(
      {.points = phase_trail_.points(), .color = setup_.style.color, .width = 2.5F});
  list.markers.push_back(
      {.position = phase_point(now()), .style = setup_.style, .size = 13});
}

void Spring::draw_reference(DrawList& list) const {
  // The wall
  const glm::mat4 place = glm::translate(glm::mat4(1), glm::vec3(-3.7F, 0.6F, 0));
  list.shapes.push_back(
      {ShapeKind::box, glm::scale(place, glm::vec3(0.1F, 0.6F, 1.7F)), k_body});

  // The exact phase portrait
  constexpr int k_pieces = 400;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= k_pieces; ++i)
    path.push_back(phase_point(exact_at(setup_.duration * i / k_pieces)));
  list.lines.push_back(
      {.points = path, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.labels.push_back({.position = {-2.2F, 3.9F, -1.2F},
                         .text = "velocity / ω over position",
                         .color = k_muted});
  list.legend.push_back({reference_style(), "exact"});
}

}  // namespace

Scene spring_scene() {
  return {
      .name = "spring",
      .summary = "a mass on a spring: energy, stability, drag and damping",
      .methods = euler_choices(),
      .default_methods = {"explicit_euler", "semi_implicit_euler", "modified_euler"},
      .parameters = {{"mass", "kg", "on the spring", 1, 1e-6, 1e6},
                     {"stiffness", "N/m", "of the spring", 10, 1e-6, 1e12},
                     {"stretch", "m", "at the start", 1, 1e-6, 1e6},
                     {"speed", "m/s", "at the start", 0, -1e6, 1e6},
                     {"linear_drag", "kg/s", "c in F = -c v", 0, 0, 1e9},
                     {"damping", "1/s", "share of v left after a second", 1, 1e-6, 1}},
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.target = {0.6F, 1.5F, 0},
                 .distance = 10.5F,
                 .yaw = 0.25F,
                 .pitch = 0.2F},
      .chart_metric = "energy_ratio",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<Spring>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
