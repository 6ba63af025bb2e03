// A billiard ball struck off its centre: it slides, spins, and comes to roll.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "chapters/03-rigid-bodies/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_cue_ball.hpp"
#include "common/physics/mass_properties.hpp"
#include "common/physics/rigid_body.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

constexpr float k_radius = 0.2F;

class CueStrike : public BodyRun {
 public:
  explicit CueStrike(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  void advance() override;
  void strike();
  Vec3 foot() const { return ball_.position - Vec3(0, radius_, 0); }
  Vec3 friction() const;
  exact::Ball exact_ball() const;
  exact::BallMotion exact_start() const;
  exact::BallMotion exact_now() const;
  glm::vec3 place(const glm::dvec3& x) const;

  Real radius_;
  RigidBody ball_;
  double slip_ = 0, rolling_time_ = 0;
  bool rolls_ = false;
  Trail trail_;
  std::vector<std::pair<glm::vec3, glm::dquat>> past_;  ///< at even intervals
};

// The closed form has z upwards and its side to the left along y
glm::dvec3 in_scene(const glm::dvec3& v) {
  return {v.x, v.z, -v.y};
}

CueStrike::CueStrike(const Setup& setup)
    : BodyRun(setup), radius_(Real(parameter("radius"))) {
  if (std::hypot(parameter("above"), parameter("aside")) >= parameter("radius"))
    throw InputError("--set above=… aside=…: the cue misses the ball");
  const Real mass = Real(parameter("mass"));
  const MassProperties solid = solid_sphere(mass, radius_);
  ball_.position = {0, radius_, 0};
  ball_.inverse_mass = 1 / mass;
  ball_.inverse_inertia = Vec3(1 / solid.inertia[0][0]);
}

// Listing 4: a force at a point off the centre, for the length of one step
void CueStrike::strike() {
  const Real above = Real(parameter("above"));
  const Real aside = Real(parameter("aside"));
  const Real depth = std::sqrt(radius_ * radius_ - above * above - aside * aside);
  const Vec3 force(Real(parameter("impulse") / setup().dt), 0, 0);
  add_force_at_point(ball_, force, ball_.position + Vec3(-depth, above, -aside));
}

// Friction at the lowest point, against the slip there: mu m g, or as much as ends the
// slip within the step
Vec3 CueStrike::friction() const {
  const Vec3 slip = velocity_at(ball_, foot());
  const Real speed = glm::length(slip);
  if (speed == 0) return Vec3(0);
  const Real weight = Real(parameter("gravity")) / ball_.inverse_mass;
  const Real responds =
      ball_.inverse_mass + radius_ * radius_ * ball_.inverse_inertia.x;
  const Real enough = speed / (responds * Real(setup().dt));
  return -std::min(Real(parameter("friction")) * weight, enough) / speed * slip;
}

void CueStrike::advance() {
  if (steps() == 0) {
    strike();
  } else {
    add_force_at_point(ball_, friction(), foot());
  }
  integrate(ball_, method().step, Real(setup().dt));
}

void CueStrike::observe() {
  // Rolling is a slip that is rounding alone: a thousandth of a thousandth of the speed
  slip_ = static_cast<double>(glm::length(velocity_at(ball_, foot())));
  const double speed = parameter("impulse") / parameter("mass");
  if (!rolls_ && steps() > 0 && slip_ <= 1e-6 * speed) {
    rolls_ = true;
    rolling_time_ = time();
  }
  const glm::vec3 at = place(glm::dvec3(ball_.position));
  if (time() >= static_cast<double>(past_.size()) * setup().duration / 8)
    past_.emplace_back(at, ball_.orientation);
  trail_.add(at);
}

exact::Ball CueStrike::exact_ball() const {
  return {.mass = parameter("mass"),
          .radius = parameter("radius"),
          .k = 0.4,
          .mu = parameter("friction"),
          .g = parameter("gravity")};
}

exact::BallMotion CueStrike::exact_start() const {
  return exact::struck(exact_ball(), parameter("impulse"), parameter("above"),
                       parameter("aside"));
}

exact::BallMotion CueStrike::exact_now() const {
  if (steps() == 0) return {exact_start().x, glm::dvec3(0), glm::dvec3(0)};
  return exact::slide_then_roll(exact_ball(), exact_start(), time());
}

std::vector<BodyState> CueStrike::bodies() const {
  return {{.name = "ball",
           .position = glm::dvec3(ball_.position),
           .velocity = glm::dvec3(ball_.velocity),
           .orientation = glm::dquat(ball_.orientation),
           .angular_velocity = glm::dvec3(ball_.angular_velocity)}};
}

std::vector<Metric> CueStrike::metrics() const {
  const exact::BallMotion exact = exact_now();
  const double rolling = exact::time_until_rolling(exact_ball(), exact_start());
  const glm::dvec3 v(ball_.velocity), omega(ball_.angular_velocity);
  return {
      {"position_error", "m",
       glm::distance(glm::dvec3(ball_.position), in_scene(exact.x))},
      {"velocity_error", "m/s", glm::distance(v, in_scene(exact.v))},
      {"spin_error", "rad/s", glm::distance(omega, in_scene(exact.omega))},
      {"speed", "m/s", glm::length(v)},
      {"topspin", "rad/s", -omega.z},
      {"side_spin", "rad/s", omega.y},
      {"slip", "m/s", slip_},
      {"rolling_time", "s", rolling_time_},
      {"rolling_time_exact", "s", std::isfinite(rolling) ? rolling : 0},
      {"rolling_height", "m", exact::rolling_height(exact_ball())},
  };
}

// The ball's radius in the picture is k_radius
glm::vec3 CueStrike::place(const glm::dvec3& x) const {
  return k_radius * glm::vec3(x / parameter("radius"));
}

// Rings about the ball's axes show how it turns
void draw_ball(DrawList& list, const glm::vec3& at, const glm::dquat& q,
               const Color& color) {
  list.balls.push_back({at, k_radius, k_paper});
  constexpr int k_pieces = 32;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= k_pieces; ++i) {
      const float angle =
          2 * std::numbers::pi_v<float> * static_cast<float>(i) / k_pieces;
      glm::vec3 p(0);
      p[(axis + 1) % 3] = 1.01F * k_radius * std::cos(angle);
      p[(axis + 2) % 3] = 1.01F * k_radius * std::sin(angle);
      ring.push_back(at + glm::quat(q) * p);
    }
    list.lines.push_back(
        {.points = ring, .color = color, .width = axis == 0 ? 4.0F : 2});
  }
}

void CueStrike::draw(DrawList& list) const {
  const glm::vec3 at = place(glm::dvec3(ball_.position));
  for (const auto& [x, q] : past_) draw_ball(list, x, q, k_muted);
  draw_ball(list, at, glm::dquat(ball_.orientation), setup().style.color);
  list.lines.push_back({.points = trail_.points(), .color = setup().style.color});

  // Friction, while there is some
  if (steps() > 0 && !rolls_) {
    const glm::vec3 foot = at - glm::vec3(0, 0.9F * k_radius, 0);
    const glm::vec3 slip = glm::normalize(glm::vec3(velocity_at(ball_, this->foot())));
    list.arrows.push_back({.from = foot, .to = foot - 0.6F * slip, .color = k_force});
  }
}

void CueStrike::draw_reference(DrawList& list) const {
  list.markers.push_back({.position = place(in_scene(exact_now().x)),
                          .style = reference_style(),
                          .size = 16});
  list.legend.push_back({reference_style(), "exact"});
  if (steps() > 0) return;

  // The cue, about to strike
  const double r = parameter("radius");
  const glm::vec3 tip = place({-r, r + parameter("above"), -parameter("aside")});
  list.lines.push_back(
      {.points = {tip - glm::vec3(1.2F, 0, 0), tip}, .color = k_ink, .width = 6});
}

}  // namespace

Scene cue_strike_scene() {
  return {
      .name = "cue-strike",
      .summary = "a billiard ball struck off its centre slides, then rolls",
      .methods = all_choices(),
      .default_methods = {"listing_3"},
      .parameters = {{"mass", "kg", "of the ball", 0.17, 1e-6, 1e6},
                     {"radius", "m", "of the ball", 0.028575, 1e-6, 1e6},
                     {"impulse", "N s", "of the cue, level", 0.3, 0, 1e9},
                     {"above", "m", "the centre, where the cue strikes", -0.01, -1e6,
                      1e6},
                     {"aside", "m", "of the centre, to the left", 0.008, -1e6, 1e6},
                     {"friction", "", "of ball and cloth", 0.2, 0, 1e3},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3}},
      .dt = 1.0 / 240,
      .duration = 0.8,
      .camera = {.target = {2.7F, 0.4F, 0},
                 .distance = 7.6F,
                 .yaw = 0.2F,
                 .pitch = 0.3F},
      .chart_metric = "slip",
      .start = [](const Setup& setup) { return std::make_unique<CueStrike>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
