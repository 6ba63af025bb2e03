// A planet about a sun that stands still: an ellipse for ever, if the method lets it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/02-verlet/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_orbit.hpp"
#include "common/physics/systems.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

class Orbit : public SchemeRun {
 public:
  explicit Orbit(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  exact::Motion here() const {
    const State state = now();
    return {wide(at(state.x, 0)), wide(at(state.v, 0))};
  }
  exact::Motion exact_at(double t) const { return exact::orbit(mu_, a_, e_, t); }
  double period() const { return 2 * std::numbers::pi * std::sqrt(a_ / mu_) * a_; }
  exact::OrbitElements elements() const { return exact::elements(mu_, here()); }
  double energy_error() const { return elements().energy / start_.energy - 1; }
  double position_error() const {
    return glm::distance(here().x, exact_at(time()).x) / a_;
  }

  // The picture's unit is the semi-major axis; the sun stands at its origin
  glm::vec3 place(const glm::dvec3& x) const { return picture(2.0 * x / a_); }

  double mu_, a_, e_;
  exact::OrbitElements start_;
  double largest_error_ = 0, largest_energy_error_ = 0, turned_ = 0;
  Trail trail_;
};

Acceleration force_of(const Setup& setup) {
  return [mu = Real(setup.parameters.at("gm"))](auto x, auto, Real, auto a) {
    put(a, 0, gravity_towards_origin(mu, at(x, 0)));
  };
}

// At the pericentre, where the speed is greatest
State start_of(const Setup& setup) {
  const exact::Motion start =
      exact::orbit(setup.parameters.at("gm"), setup.parameters.at("semi_major_axis"),
                   setup.parameters.at("eccentricity"), 0);
  State state = particles(1);
  put(state.x, 0, Vec3(start.x));
  put(state.v, 0, Vec3(start.v));
  return state;
}

Orbit::Orbit(const Setup& setup)
    : SchemeRun(setup, force_of(setup), start_of(setup),
                setup.parameters.at("time_lapse")),
      mu_(setup.parameters.at("gm")),
      a_(setup.parameters.at("semi_major_axis")),
      e_(setup.parameters.at("eccentricity")),
      start_(exact::elements(mu_, exact_at(0))) {}

void Orbit::observe() {
  largest_error_ = std::max(largest_error_, position_error());
  largest_energy_error_ = std::max(largest_energy_error_, std::abs(energy_error()));

  // Whole turns of the ellipse count on
  turned_ += std::remainder(elements().pericentre - turned_, 2 * std::numbers::pi);
  trail_.add(place(here().x));
}

std::vector<BodyState> Orbit::bodies() const {
  const exact::Motion m = here();
  return {{.name = "planet", .position = m.x, .velocity = m.v}};
}

std::vector<Metric> Orbit::metrics() const {
  const exact::OrbitElements e = elements();
  const double orbits = time() / period();
  constexpr double k_arcseconds = 180 * 3600 / std::numbers::pi;
  constexpr double k_century = 36525 * 86400.0;
  return {
      {"position_error", "", position_error()},
      {"position_error_max", "", largest_error_},
      {"energy_error", "", energy_error()},
      {"energy_error_max", "", largest_energy_error_},
      {"angular_momentum_error", "", e.angular_momentum / start_.angular_momentum - 1},
      {"apsis_rotation", "rad", turned_},
      {"apsis_rotation_per_orbit", "rad", orbits > 0 ? turned_ / orbits : 0},
      {"apsis_rotation_per_century", "arcsec",
       orbits > 0 ? turned_ * k_arcseconds * k_century / time() : 0},
      {"eccentricity", "", e.eccentricity},
      {"orbits", "", orbits},
      {"steps_per_orbit", "", period() / dt()},
  };
}

void Orbit::draw(DrawList& list) const {
  list.lines.push_back({.points = trail_.points(),
                        .color = setup().style.color,
                        .width = 2,
                        .fade = true});
  list.balls.push_back({place(here().x), 0.07F, setup().style.color});
  list.markers.push_back(
      {.position = place(here().x), .style = setup().style, .size = 14});
}

void Orbit::draw_reference(DrawList& list) const {
  // The sun, the ellipse, and where the planet should be
  list.balls.push_back({{0, 0, 0}, 0.14F, {0.93F, 0.69F, 0.13F, 1}});
  constexpr int k_pieces = 400;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= k_pieces; ++i)
    path.push_back(place(exact_at(period() * i / k_pieces).x));
  list.lines.push_back(
      {.points = path, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.markers.push_back(
      {.position = place(exact_at(time()).x), .style = reference_style(), .size = 14});
  list.legend.push_back({reference_style(), "exact"});
  list.ground_height.reset();
}

// An orbit about the sun, sped up so that it takes 2 pi seconds of the scene.
// a in astronomical units.
Preset solar(const std::string& name, double a, double e, const std::string& source) {
  constexpr double k_sun = 1.32712440018e20;    // GM, JPL DE405
  constexpr double k_unit = 149'597'870'700.0;  // IAU 2012, Resolution B2
  const double metres = a * k_unit;
  return {name,
          source + "; GM of the sun: JPL DE405",
          {{"gm", k_sun},
           {"semi_major_axis", metres},
           {"eccentricity", e},
           {"time_lapse", std::sqrt(metres / k_sun) * metres}}};
}

std::vector<Preset> solar_system() {
  const std::string planets =
      "elements at J2000: E. M. Standish, Keplerian elements for approximate positions "
      "of the major planets (JPL), table 1";
  return {
      solar("earth", 1.00000261, 0.01671123, planets),
      solar("mercury", 0.38709927, 0.20563593, planets),
      solar("halley", 17.834, 0.96714, "elements: JPL Small-Body Database, 1P/Halley")};
}

}  // namespace

Scene orbit_scene() {
  constexpr double k_turn = 2 * std::numbers::pi;
  return {
      .name = "orbit",
      .summary = "a planet about a fixed sun: energy, and an ellipse that turns",
      .methods = all_choices(),
      .default_methods = {"semi_implicit_euler", "velocity_verlet", "midpoint", "rk4"},
      .parameters = {{"gm", "m³/s²", "gravity of the sun", 1, 1e-6, 1e30},
                     {"semi_major_axis", "m", "of the ellipse", 1, 1e-6, 1e15},
                     {"eccentricity", "", "0 is a circle", 0.5, 0, 0.99},
                     {"time_lapse", "s/s", "seconds of the orbit in one of the scene",
                      1, 1e-9, 1e12},
                     tolerance_parameter()},
      .presets = solar_system(),
      .dt = k_turn / 100,
      .duration = 10 * k_turn,
      .camera = {.target = {0.2F, -0.1F, 0}, .distance = 10.5F, .yaw = 0, .pitch = 0},
      .chart_metric = "energy_error",
      .start = [](const Setup& setup) { return std::make_unique<Orbit>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
