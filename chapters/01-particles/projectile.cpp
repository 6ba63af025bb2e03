// A ball thrown through still air: every method's path over the exact one.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "chapters/01-particles/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

class Projectile : public Simulation {
 public:
  explicit Projectile(const Setup& setup);

  void step() override {
    const Real t = Real(static_cast<double>(steps_) * setup_.dt);
    method_.step(ball_, acceleration_, t, Real(setup_.dt));
    ++steps_;
  }

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return steps_ * method_.evaluations; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  double time() const { return static_cast<double>(steps_) * setup_.dt; }
  exact::Motion exact_at(double t) const;
  exact::Motion now() const { return {wide(at(ball_.x, 0)), wide(at(ball_.v, 0))}; }
  double energy(const exact::Motion& m) const;
  double scale() const;

  Setup setup_;
  NamedIntegrator method_;
  Acceleration acceleration_;
  exact::Motion start_;
  double mass_, linear_, quadratic_;
  glm::dvec3 g_;
  State ball_ = particles(1);
  long long steps_ = 0;
  double largest_error_ = 0;
  Trail trail_;
};

Projectile::Projectile(const Setup& setup)
    : setup_(setup),
      method_(euler_method(setup.method)),
      mass_(setup.parameters.at("mass")),
      linear_(setup.parameters.at("linear_drag")),
      quadratic_(setup.parameters.at("quadratic_drag")),
      g_(0, -setup.parameters.at("gravity"), 0) {
  if (linear_ > 0 && quadratic_ > 0)
    throw InputError(
        "linear_drag and quadratic_drag: set one of them, the exact path "
        "is known for either but not for both");

  // The start, and the same rounded to the precision of the run
  const double speed = setup.parameters.at("speed");
  const double angle = setup.parameters.at("angle");
  start_.x = {setup.parameters.at("origin"), setup.parameters.at("height"), 0};
  start_.v = speed * glm::dvec3(std::cos(angle), std::sin(angle), 0);
  put(ball_.x, 0, Vec3(start_.x));
  put(ball_.v, 0, Vec3(start_.v));

  // (1.1), (1.6), (1.8), (1.9) Newton's law with weight and drag
  acceleration_ = [m = Real(mass_), inverse_mass = Real(1 / mass_), g = Vec3(g_),
                   c = Real(linear_),
                   k = Real(quadratic_)](auto, auto v, Real, auto a) {
    const Vec3 velocity = at(v, 0);
    const Vec3 force =
        weight(m, g) + linear_drag(c, velocity) + quadratic_drag(k, velocity);
    put(a, 0, newton(force, inverse_mass));
  };
}

exact::Motion Projectile::exact_at(double t) const {
  if (quadratic_ > 0) return exact::quadratic_drag(start_, g_, quadratic_ / mass_, t);
  return exact::linear_drag(start_, g_, linear_ / mass_, t);
}

double Projectile::energy(const exact::Motion& m) const {
  return mass_ * (glm::dot(m.v, m.v) / 2 - glm::dot(g_, m.x - start_.x));
}

void Projectile::observe() {
  const exact::Motion m = now();
  largest_error_ = std::max(largest_error_, glm::distance(m.x, exact_at(time()).x));
  trail_.add(picture(m.x));
}

std::vector<BodyState> Projectile::bodies() const {
  const exact::Motion m = now();
  return {{.name = "ball", .position = m.x, .velocity = m.v}};
}

std::vector<Metric> Projectile::metrics() const {
  const exact::Motion m = now();
  const exact::Motion e = exact_at(time());
  return {
      {"position_error", "m", glm::distance(m.x, e.x)},
      {"position_error_max", "m", largest_error_},
      {"velocity_error", "m/s", glm::distance(m.v, e.v)},
      {"energy_error", "J", energy(m) - energy(e)},
      {"x", "m", m.x.x},
      {"y", "m", m.x.y},
      {"x_exact", "m", e.x.x},
      {"y_exact", "m", e.x.y},
  };
}

// Sizes on the picture, in proportion to the flight: the default one is 18 m long.
double Projectile::scale() const {
  return std::max(glm::distance(exact_at(setup_.duration).x, start_.x) / 18, 1e-3);
}

CameraPose Projectile::camera(const CameraPose& usual) const {
  CameraPose pose = usual;
  pose.distance *= static_cast<float>(scale());
  pose.target = picture(start_.x) + static_cast<float>(scale()) * usual.target;
  return pose;
}

void Projectile::draw(DrawList& list) const {
  const auto size = static_cast<float>(scale());
  const glm::dvec3 here = now().x;

  // The path, a dot for each step while they are few, and the ball
  list.lines.push_back(
      {.points = trail_.points(), .color = setup_.style.color, .width = 3});
  if (steps_ <= 60)
    for (const glm::vec3& point : trail_.points())
      list.balls.push_back({point, 0.09F * size, setup_.style.color});
  list.balls.push_back({picture(here), 0.28F * size, setup_.style.color});

  const double error = glm::distance(here, exact_at(time()).x);
  if (steps_ > 0)
    list.labels.push_back({.position = picture(here),
                           .text = error < 1e-9 * glm::length(start_.v)
                                       ? "exact but for rounding"
                                       : fmt::format("{:.3g} m off", error),
                           .color = setup_.style.color});
}

void Projectile::draw_reference(DrawList& list) const {
  constexpr int k_pieces = 200;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= k_pieces; ++i)
    path.push_back(picture(exact_at(setup_.duration * i / k_pieces).x));
  list.lines.push_back(
      {.points = path, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.balls.push_back(
      {picture(exact_at(time()).x), static_cast<float>(0.28 * scale()), k_ink});
  list.legend.push_back({reference_style(), "exact"});
}

// k = ρ C_d A / 2 of a ball [kg/m] in air of 1.2 kg/m³.
constexpr double ball_drag(double drag_coefficient, double diameter) {
  return 1.2 * drag_coefficient * std::numbers::pi * diameter * diameter / 4 / 2;
}

std::vector<Preset> balls() {
  return {
      {"baseball",
       "mass, circumference: Official Baseball Rules 3.01 (middle of the range); k/m "
       "at "
       "40 m/s: Giordano's fit 0.0039 + 0.0058 / (1 + exp((v - 35) / 5)) per metre",
       {{"mass", 0.1453},
        {"speed", 40},
        {"angle", 0.6},
        {"height", 1},
        {"quadratic_drag", 0.1453 * 0.00546}}},
      {"ping-pong",
       "2.7 g, 40 mm: ITTF Laws of Table Tennis 2.3; C_d = 0.5, a smooth sphere at "
       "Reynolds "
       "numbers of 1e3 to 1e5",
       {{"mass", 0.0027},
        {"speed", 15},
        {"angle", 0.6},
        {"height", 1},
        {"quadratic_drag", ball_drag(0.5, 0.04)}}},
      {"shuttlecock",
       "5 g, section 28 cm², C_d = 0.6: Cohen et al., The physics of badminton, New J. "
       "Phys. 17 (2015) 063001",
       {{"mass", 0.005},
        {"speed", 40},
        {"angle", 0.8},
        {"height", 1},
        {"quadratic_drag", 1.2 * 0.6 * 28e-4 / 2}}},
  };
}

}  // namespace

Scene projectile_scene() {
  constexpr double k_quarter = std::numbers::pi / 2;
  return {
      .name = "projectile",
      .summary = "a thrown ball: each method's path over the exact one",
      .methods = euler_choices(),
      .default_methods = {"explicit_euler", "semi_implicit_euler", "modified_euler"},
      .parameters = {{"mass", "kg", "of the ball", 1, 1e-6, 1e6},
                     {"speed", "m/s", "at the start", 14, 0, 1e6},
                     {"angle", "rad", "of the throw above the ground", 1, -k_quarter,
                      k_quarter},
                     {"height", "m", "of the hand", 0, -1e6, 1e6},
                     {"origin", "m", "x of the hand: far out, digits are lost", 0, -1e9,
                      1e9},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
                     {"linear_drag", "kg/s", "c in F = -c v", 0, 0, 1e6},
                     {"quadratic_drag", "kg/m", "k in F = -k |v| v", 0, 0, 1e6}},
      .presets = balls(),
      .dt = 0.1,
      .duration = 2.4,
      .camera = {.target = {10.5F, 1.6F, 0}, .distance = 20, .yaw = 0, .pitch = 0.14F},
      .chart_metric = "position_error",
      .start = [](const Setup& setup) { return std::make_unique<Projectile>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
