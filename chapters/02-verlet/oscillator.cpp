// A mass on a spring in its phase plane, undamped, damped, and stiff.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "chapters/02-verlet/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/stability.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

// Picture: position to the right, velocity / omega upwards, in amplitudes at the start
constexpr double k_scale = 2;
constexpr double k_edge = 2.2;  // beyond so many amplitudes nothing is drawn

class Oscillator : public SchemeRun {
 public:
  // Finding the limit of a scheme takes some ten thousand steps
  Oscillator(const Setup& setup, bool find_limit);

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
    return exact::oscillator(start_, omega_, gamma_, t);
  }
  double energy(const exact::Coordinate& c) const;
  double modified(const exact::Coordinate& c) const;
  double drift(const exact::Coordinate& c) const;
  double state_error() const;
  glm::dvec2 in_phase_plane(const exact::Coordinate& c) const;

  double mass_, stiffness_, omega_, gamma_;
  exact::Coordinate start_;
  std::optional<double> limit_;
  StepMatrix matrix_{};
  ModifiedEnergy form_{.xx = 0.5, .xv = 0, .vv = 0.5};
  double largest_error_ = 0, largest_energy_error_ = 0, largest_drift_ = 0;
  Trail trail_;
};

// Newton's law for the spring, with linear drag
Acceleration force_of(const Setup& setup) {
  const Real inverse_mass = Real(1 / setup.parameters.at("mass"));
  const Real k = Real(setup.parameters.at("stiffness"));
  const Real c = Real(setup.parameters.at("linear_drag"));
  return [k, c, inverse_mass](auto x, auto v, Real, auto a) {
    a[0] = (-k * x[0] - c * v[0]) * inverse_mass;
  };
}

State start_of(const Setup& setup) {
  return {.x = {Real(setup.parameters.at("stretch"))},
          .v = {Real(setup.parameters.at("speed"))},
          .a = {0}};
}

Oscillator::Oscillator(const Setup& setup, bool find_limit)
    : SchemeRun(setup, force_of(setup), start_of(setup)),
      mass_(setup.parameters.at("mass")),
      stiffness_(setup.parameters.at("stiffness")),
      omega_(std::sqrt(stiffness_ / mass_)),
      gamma_(setup.parameters.at("linear_drag") / mass_ / 2),
      start_{setup.parameters.at("stretch"), setup.parameters.at("speed")} {
  constexpr double k_no_limit = 100;
  if (find_limit) limit_ = k_no_limit;
  if (is_adaptive()) return;

  // (2.32), (2.35) What the scheme keeps in place of the energy
  const double z = omega_ * dt();
  matrix_ = step_matrix(scheme(), Real(z));
  if (scheme().symplectic) form_ = modified_energy(matrix_, z);

  // (2.34)
  if (find_limit) limit_ = std::min(stability_limit(scheme()), k_no_limit);
}

double Oscillator::energy(const exact::Coordinate& c) const {
  return (mass_ * c.v * c.v + stiffness_ * c.x * c.x) / 2;
}

double Oscillator::modified(const exact::Coordinate& c) const {
  const double y = c.v / omega_;
  return stiffness_ * (form_.xx * c.x * c.x + form_.xv * c.x * y + form_.vv * y * y);
}

// Of the modified energy since the start; that may be 0, where a method is past its
// limit
double Oscillator::drift(const exact::Coordinate& c) const {
  return (modified(c) - modified(start_)) / energy(start_);
}

glm::dvec2 Oscillator::in_phase_plane(const exact::Coordinate& c) const {
  return glm::dvec2(c.x, c.v / omega_) / std::hypot(start_.x, start_.v / omega_);
}

double Oscillator::state_error() const {
  return glm::distance(in_phase_plane(here()), in_phase_plane(exact_at(time())));
}

glm::vec3 place(const glm::dvec2& p) {
  return {k_scale * p.x, k_scale * p.y, 0};
}

void Oscillator::observe() {
  const exact::Coordinate c = here();
  const double e = energy(c) - energy(exact_at(time()));
  largest_energy_error_ = std::max(largest_energy_error_, std::abs(e) / energy(start_));
  largest_error_ = std::max(largest_error_, state_error());
  largest_drift_ = std::max(largest_drift_, std::abs(drift(c)));
  if (glm::length(in_phase_plane(c)) < k_edge) trail_.add(place(in_phase_plane(c)));
}

std::vector<BodyState> Oscillator::bodies() const {
  const exact::Coordinate c = here();
  return {{.name = "mass", .position = {c.x, 0, 0}, .velocity = {c.v, 0, 0}}};
}

std::vector<Metric> Oscillator::metrics() const {
  const exact::Coordinate c = here();
  const exact::Coordinate e = exact_at(time());
  std::vector<Metric> all{
      {"state_error", "", state_error()},
      {"state_error_max", "", largest_error_},
      {"energy_error", "", (energy(c) - energy(e)) / energy(start_)},
      {"energy_error_max", "", largest_energy_error_},
      {"energy_ratio", "", energy(c) / energy(start_)},
      {"modified_energy_drift", "", drift(c)},
      {"modified_energy_drift_max", "", largest_drift_},
      {"position_error", "m", std::abs(c.x - e.x)},
      {"omega_dt", "", omega_ * dt()},
      {"spectral_radius", "", is_adaptive() ? 1 : spectral_radius(matrix_)},
      {"x", "m", c.x},
      {"v", "m/s", c.v},
      {"x_exact", "m", e.x},
  };
  if (limit_) all.push_back({"stability_limit", "", *limit_});
  return all;
}

// The curve of constant modified energy through the start, where it is an ellipse
std::vector<glm::vec3> modified_orbit(const ModifiedEnergy& form,
                                      const glm::dvec2& start) {
  const auto of = [&](const glm::dvec2& p) {
    return form.xx * p.x * p.x + form.xv * p.x * p.y + form.vv * p.y * p.y;
  };
  std::vector<glm::vec3> curve;
  constexpr int k_pieces = 200;
  for (int i = 0; i <= k_pieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / k_pieces;
    const glm::dvec2 way{std::cos(angle), std::sin(angle)};
    const double r = std::sqrt(of(start) / of(way));
    if (!(r < k_edge)) return {};
    curve.push_back(place(r * way));
  }
  return curve;
}

void Oscillator::draw(DrawList& list) const {
  // What the scheme keeps, and what it did
  if (!is_adaptive() && scheme().symplectic && gamma_ == 0)
    list.lines.push_back({.points = modified_orbit(form_, in_phase_plane(start_)),
                          .color = setup().style.color,
                          .width = 1.5F,
                          .dash = Dash::dotted});
  std::vector<glm::vec3> points = trail_.points();
  if (points.size() > 60) points.erase(points.begin(), points.end() - 60);
  list.lines.push_back(
      {.points = points, .color = setup().style.color, .width = 2, .fade = true});

  const glm::dvec2 p = in_phase_plane(here());
  if (glm::length(p) < k_edge)
    list.markers.push_back({.position = place(p), .style = setup().style, .size = 16});
}

void Oscillator::draw_reference(DrawList& list) const {
  // The axes
  for (const glm::dvec2& axis : {glm::dvec2(1.3, 0), glm::dvec2(0, 1.3)})
    list.arrows.push_back(
        {.from = place(-axis), .to = place(axis), .color = k_muted, .width = 1.5F});
  list.labels.push_back(
      {.position = place({1.32, 0}), .text = "position", .color = k_muted});
  list.labels.push_back(
      {.position = place({0, 1.35}), .text = "velocity / ω", .color = k_muted});

  // The exact curve, and where the mass is on it
  constexpr int k_pieces = 400;
  const double once = std::min(2 * std::numbers::pi / omega_, setup().duration);
  const double whole = gamma_ > 0 ? setup().duration : once;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= k_pieces; ++i)
    path.push_back(place(in_phase_plane(exact_at(whole * i / k_pieces))));
  list.lines.push_back(
      {.points = path, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.markers.push_back({.position = place(in_phase_plane(exact_at(time()))),
                          .style = reference_style(),
                          .size = 14});
  list.legend.push_back({reference_style(), "exact"});
  list.ground_height.reset();
}

// What the three scenes have in common
Scene spring_scene(const std::string& name, const std::string& summary,
                   double stiffness, double drag) {
  return {
      .name = name,
      .summary = summary,
      .methods = all_choices(),
      .default_methods = {},
      .parameters = {{"mass", "kg", "on the spring", 1, 1e-6, 1e6},
                     {"stiffness", "N/m", "of the spring", stiffness, 1e-6, 1e12},
                     {"stretch", "m", "at the start", 1, 1e-6, 1e6},
                     {"speed", "m/s", "at the start", 0, -1e6, 1e6},
                     {"linear_drag", "kg/s", "c in F = -c v", drag, 0, 1e9},
                     tolerance_parameter()},
      .camera = {.target = {0.7F, 0, 0}, .distance = 7.8F, .yaw = 0, .pitch = 0},
      .start =
          [](const Setup& setup) { return std::make_unique<Oscillator>(setup, false); },
  };
}

}  // namespace

Scene oscillator_scene() {
  Scene scene = spring_scene(
      "oscillator", "a mass on a spring: what each method keeps in place of the energy",
      1, 0);
  scene.default_methods = {"semi_implicit_euler", "velocity_verlet", "position_verlet",
                           "rk4"};
  scene.dt = 0.5;
  scene.duration = 60;
  scene.chart_metric = "energy_ratio";
  return scene;
}

Scene damped_oscillator_scene() {
  Scene scene = spring_scene(
      "damped-oscillator",
      "a spring with drag: Verlet needs a velocity that it does not have yet", 4, 0.8);
  scene.methods =
      choices({"verlet_lagged", "verlet_half", "verlet_predicted", "verlet_implicit",
               "velocity_verlet", "semi_implicit_euler", "semi_implicit_implicit_drag",
               "explicit_euler", "midpoint", "rk4", "implicit_euler",
               "implicit_midpoint", "implicit_trapezoid", k_adaptive});
  scene.default_methods = {"verlet_lagged", "verlet_half", "verlet_predicted",
                           "verlet_implicit"};
  scene.dt = 0.25;
  scene.duration = 8;
  scene.chart_metric = "state_error";
  scene.chart_logarithmic = true;
  return scene;
}

Scene stiff_spring_scene() {
  Scene scene =
      spring_scene("stiff-spring",
                   "ω dt = 5/3: beyond some methods' limits, within others'", 1e4, 0);
  scene.default_methods = {"semi_implicit_euler", "velocity_verlet",
                           "yoshida4_kdk",        "rk4",
                           "implicit_euler",      "implicit_midpoint"};
  scene.dt = 1.0 / 60;
  scene.duration = 1;
  scene.chart_metric = "energy_ratio";
  scene.chart_logarithmic = true;
  scene.start = [](const Setup& setup) {
    return std::make_unique<Oscillator>(setup, true);
  };
  return scene;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
