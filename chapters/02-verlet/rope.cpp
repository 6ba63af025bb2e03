// A rope that swings down from a held end: rods without forces beside stiff springs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "chapters/02-verlet/parts.hpp"
#include "chapters/02-verlet/recent_trail.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/distance_constraint.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/systems.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {
namespace {

constexpr std::string_view k_rods = "distance_constraints";
constexpr double k_torn = 10;  // stretched more than so, a rope is not drawn
constexpr double k_horizontal = std::numbers::pi / 2;

// What the parameters say. Particle 0 is held, the others share the mass evenly.
struct Rope {
  std::size_t links;
  double length, mass, stiffness, gravity, angle;

  double link_length() const { return length / static_cast<double>(links); }
  double particle_mass() const { return mass / static_cast<double>(links); }
};

Rope rope_of(const Setup& setup) {
  const auto value = [&](const char* name) { return setup.parameters.at(name); };
  return {static_cast<std::size_t>(value("particles")) - 1,
          value("length"),
          value("mass"),
          value("stiffness"),
          value("gravity"),
          value("angle")};
}

class RopeRun : public SchemeRun {
 public:
  explicit RopeRun(const Setup& setup);

  void step() override;
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return SchemeRun::evaluations() + passes_; }
  long long body_count() const override { return static_cast<long long>(rope_.links); }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  void satisfy_rods(std::span<Real> x) const {
    satisfy(rods_, inverse_mass_, iterations_, x);
  }
  State read_rods();
  double stretch() const;
  double energy() const;
  double energy_error() const;
  glm::dvec3 particle(std::size_t i) const { return wide(at(now_.x, i)); }
  glm::vec3 place(std::size_t i) const;

  Rope rope_;
  std::vector<DistanceConstraint> rods_;
  std::vector<Real> inverse_mass_;
  int iterations_;
  long long passes_ = 0;

  State now_;
  double start_energy_ = 0, largest_stretch_ = 0, largest_energy_error_ = 0;
  RecentTrail trail_;
};

// Straight, at rest, at an angle from hanging
State start_of(const Rope& rope) {
  State state = particles(rope.links + 1);
  const glm::dvec3 along{std::sin(rope.angle), -std::cos(rope.angle), 0};
  for (std::size_t i = 0; i <= rope.links; ++i)
    put(state.x, i, Vec3(static_cast<double>(i) * rope.link_length() * along));
  return state;
}

// Gravity, and between neighbours (2.25) springs unless rods hold them together
Acceleration force_of(const Rope& rope, bool springs) {
  std::vector<SpringBetween> links;
  for (std::size_t i = 0; springs && i < rope.links; ++i)
    links.push_back({i, i + 1, Real(rope.link_length()), Real(rope.stiffness)});
  const Vec3 g(0, Real(-rope.gravity), 0);
  const Real inverse_mass = Real(1 / rope.particle_mass());

  return [links, g, inverse_mass](auto x, auto, Real, auto a) {
    for (std::size_t i = 0; i < a.size() / 3; ++i) put(a, i, g);
    for (const SpringBetween& link : links) {
      const Vec3 pull = force_on_first(link, x) * inverse_mass;
      put(a, link.i, at(a, link.i) + pull);
      put(a, link.j, at(a, link.j) - pull);
    }
    put(a, 0, Vec3(0));
  };
}

// Rods take Störmer's step before they are satisfied
Setup scheme_for(const Setup& setup) {
  Setup changed = setup;
  if (setup.method == k_rods) changed.method = "stormer_verlet";
  return changed;
}

RopeRun::RopeRun(const Setup& setup)
    : SchemeRun(scheme_for(setup), force_of(rope_of(setup), setup.method != k_rods),
                start_of(rope_of(setup))),
      rope_(rope_of(setup)),
      inverse_mass_(rope_.links + 1, Real(1 / rope_.particle_mass())),
      iterations_(static_cast<int>(setup.parameters.at("iterations"))),
      now_(now()) {
  inverse_mass_[0] = 0;
  start_energy_ = energy();
  if (setup.method != k_rods) return;

  // The place before the start obeys the rods as well
  for (std::size_t i = 0; i < rope_.links; ++i)
    rods_.push_back({i, i + 1, Real(rope_.link_length())});
  satisfy_rods(integration().stages[0].x);
}

void RopeRun::step() {
  SchemeRun::step();
  if (rods_.empty()) return;

  // (2.26) A pass through the rods costs what an evaluation of the springs does
  satisfy_rods(integration().state.x);
  passes_ += iterations_;
}

// Rods act on velocities as well: half the way from the place before to the next one
State RopeRun::read_rods() {
  Integration ahead = integration();
  const std::vector<Real> before = ahead.stages[0].x;
  State now = ahead.state;
  advance(ahead);
  satisfy_rods(ahead.state.x);
  for (std::size_t i = 0; i < now.v.size(); ++i)
    now.v[i] = (ahead.state.x[i] - before[i]) / (2 * ahead.dt);
  return now;
}

void RopeRun::observe() {
  now_ = rods_.empty() ? now() : read_rods();
  largest_stretch_ = std::max(largest_stretch_, stretch());
  largest_energy_error_ = std::max(largest_energy_error_, std::abs(energy_error()));
  trail_.add(time(), place(rope_.links));
}

// Of the link that is farthest from its length, as a share of that
double RopeRun::stretch() const {
  double most = 0;
  for (std::size_t i = 0; i < rope_.links; ++i) {
    const double length = glm::distance(particle(i), particle(i + 1));
    most = std::max(most, std::abs(length / rope_.link_length() - 1));
  }
  return most;
}

// [J] Of motion, of height, and of the springs
double RopeRun::energy() const {
  const double m = rope_.particle_mass();
  double sum = 0;
  for (std::size_t i = 1; i <= rope_.links; ++i) {
    const glm::dvec3 v = wide(at(now_.v, i));
    sum += m * (glm::dot(v, v) / 2 + rope_.gravity * particle(i).y);

    if (!rods_.empty()) continue;
    const double length = glm::distance(particle(i - 1), particle(i));
    sum += rope_.stiffness * std::pow(length - rope_.link_length(), 2) / 2;
  }
  return sum;
}

// In units of the rope's weight times its length; without weight nothing moves
double RopeRun::energy_error() const {
  const double scale = rope_.mass * rope_.gravity * rope_.length;
  return scale > 0 ? (energy() - start_energy_) / scale : 0;
}

std::vector<BodyState> RopeRun::bodies() const {
  std::vector<BodyState> all;
  for (std::size_t i = 0; i <= rope_.links; ++i)
    all.push_back({.name = fmt::format("particle {}", i),
                   .position = particle(i),
                   .velocity = wide(at(now_.v, i))});
  return all;
}

std::vector<Metric> RopeRun::metrics() const {
  const glm::dvec3 tip = particle(rope_.links);
  return {
      {"stretch", "", stretch()},
      {"stretch_max", "", largest_stretch_},
      {"energy_error", "", energy_error()},
      {"energy_error_max", "", largest_energy_error_},
      {"omega_dt", "", 2 * std::sqrt(rope_.stiffness / rope_.particle_mass()) * dt()},
      {"tip_x", "m", tip.x},
      {"tip_y", "m", tip.y},
  };
}

// The held end is the origin, the rope at rest two units long
glm::vec3 RopeRun::place(std::size_t i) const {
  return picture(2.0 / rope_.length * particle(i));
}

void RopeRun::draw(DrawList& list) const {
  if (stretch() > k_torn) return;
  const Style& style = setup().style;
  std::vector<glm::vec3> rope;
  for (std::size_t i = 0; i <= rope_.links; ++i) {
    rope.push_back(place(i));
    list.balls.push_back({rope.back(), 0.045F, style.color});
  }
  list.lines.push_back(
      {.points = rope, .color = style.color, .width = 3, .dash = style.dash});
  list.lines.push_back({.points = trail_.points(), .color = style.color, .fade = true});
  list.markers.push_back({rope.back(), style, 14});
}

void RopeRun::draw_reference(DrawList& list) const {
  // As far as a rope can reach that does not stretch
  constexpr int k_pieces = 100;
  std::vector<glm::vec3> reach;
  for (int i = -k_pieces; i <= k_pieces; ++i) {
    const double angle = k_horizontal * i / k_pieces;
    reach.push_back(picture({2 * std::sin(angle), -2 * std::cos(angle), 0}));
  }
  list.lines.push_back(
      {.points = reach, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.balls.push_back({{0, 0, 0}, 0.06F, k_body});
  list.legend.push_back({reference_style(), "the rope's length"});
  list.ground_height.reset();
}

}  // namespace

Scene rope_scene() {
  return {
      .name = "rope",
      .summary = "a rope swings down: distance constraints beside stiff springs",
      .methods = choices(
          {k_rods, "semi_implicit_euler", "velocity_verlet", "rk4", "implicit_euler"}),
      .default_methods = {std::string(k_rods), "velocity_verlet", "implicit_euler"},
      .parameters = {{"particles", "", "the held one included", 12, 2, 40, true},
                     {"length", "m", "of the rope", 2, 1e-3, 1e3},
                     {"mass", "kg", "of the rope", 1, 1e-6, 1e6},
                     {"stiffness", "N/m", "of every link, for springs", 1e3, 1e-6,
                      1e12},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
                     {"iterations", "", "through the rods, in a step", 10, 1, 1e4,
                      true},
                     {"angle", "rad", "at the start, from hanging", k_horizontal,
                      -k_horizontal, k_horizontal}},
      .dt = 1.0 / 120,
      .duration = 4,
      .camera = {.target = {-0.63F, -1.05F, 0}, .distance = 5.2F, .yaw = 0, .pitch = 0},
      .chart_metric = "energy_error",
      .start = [](const Setup& setup) { return std::make_unique<RopeRun>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
