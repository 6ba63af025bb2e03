// Balls in a row that touch: some swing in at one end, and the solver decides who
// leaves.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_bounce.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

constexpr double k_radius = 0.125, k_mass = 1;  // [m], [kg]
constexpr float k_thread = 1.4F;                // [m] as long as the picture shows it

class Cradle : public WorldRun {
 public:
  explicit Cradle(const Setup& setup);
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  // One after the other and all at once: speeds right after the first impact [m/s]
  struct Outcomes {
    std::vector<double> pairwise, together;
  };

  void before_step() override;
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  Outcomes outcomes() const;
  double omega() const { return 2 * std::numbers::pi / parameter("period"); }
  double speed() const { return omega() * parameter("lift"); }
  double place_of(std::size_t ball) const;
  double swing_of(std::size_t ball) const;
  double speed_after_impact(std::size_t ball) const;
  double distance_to(const std::vector<double>& exact) const;

  std::vector<BodyHandle> balls_;
  std::vector<double> after_;  // [m/s] right after the first impact, once it is known
  double energy_ = 0, energy_error_ = 0;
};

Cradle::Cradle(const Setup& setup) : WorldRun(setup, {.lanes_apart = {0, -1.8F, 0}}) {
  const auto count = static_cast<std::size_t>(parameter("balls"));
  const auto lifted = std::min(static_cast<std::size_t>(parameter("lifted")), count);
  for (std::size_t i = 0; i < count; ++i) {
    balls_.push_back({});
    const double x = place_of(i) - (i < lifted ? parameter("lift") : 0);
    balls_[i] =
        add(fmt::format("ball {}", i + 1), ball_body(k_mass, k_radius, {x, 0, 0}),
            ball_collider(k_radius, 0, parameter("restitution")),
            body_color(i < lifted ? 1 : 0));
  }
}

// [m] Where a ball hangs at rest: the first one at 0
double Cradle::place_of(std::size_t ball) const {
  return static_cast<double>(ball) * (2 * k_radius + parameter("gap"));
}

// [m] To the right of there
double Cradle::swing_of(std::size_t ball) const {
  return place(body_of(world(), balls_[ball])).x - place_of(ball);
}

// A long thread pulls each ball back to its place. Taken where the ball would be in the
// middle of the step, the force neither adds energy nor takes it
void Cradle::before_step() {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    RigidBody& body = body_of(world(), balls_[i]);
    const double v = static_cast<double>(body.velocity.x);
    const double swing = swing_of(i) + setup().dt / 2 * v;
    add_force(body, {Real(-k_mass * omega() * omega() * swing), 0, 0});
  }
}

// [m/s] A ball that swings freely since the first impact left it with this speed then
double Cradle::speed_after_impact(std::size_t ball) const {
  const double phase = omega() * time() - std::numbers::pi / 2;
  const double v = static_cast<double>(body_of(world(), balls_[ball]).velocity.x);
  return v * std::cos(phase) + omega() * swing_of(ball) * std::sin(phase);
}

void Cradle::after_step() {
  // Half a period after the start all that left are farthest from the others
  if (after_.empty() && 2 * time() >= parameter("period") * (1 - 1e-9))
    for (std::size_t i = 0; i < balls_.size(); ++i)
      after_.push_back(speed_after_impact(i));

  double energy = kinetic_energy_of(world());
  for (std::size_t i = 0; i < balls_.size(); ++i)
    energy += k_mass * std::pow(omega() * swing_of(i), 2) / 2;
  if (steps() == 0) energy_ = energy;
  energy_error_ = std::max(energy_error_, std::abs(energy - energy_) / energy_);
}

Cradle::Outcomes Cradle::outcomes() const {
  const std::vector<double> masses(balls_.size(), k_mass);
  std::vector<double> before(balls_.size(), 0);
  const auto lifted = static_cast<std::size_t>(parameter("lifted"));
  for (std::size_t i = 0; i < std::min(lifted, balls_.size()); ++i) before[i] = speed();
  const double e = parameter("restitution");
  return {exact::pair_impacts(masses, before, e).velocities,
          exact::row_impact(masses, before, e).velocities};
}

// The largest difference, as a share of the speed before
double Cradle::distance_to(const std::vector<double>& exact) const {
  double most = 0;
  for (std::size_t i = 0; i < after_.size(); ++i)
    most = std::max(most, std::abs(after_[i] - exact[i]) / speed());
  return most;
}

std::vector<Metric> Cradle::own_metrics() const {
  const Outcomes exact = outcomes();
  return {{"pairwise_error", "", distance_to(exact.pairwise)},
          {"together_error", "", distance_to(exact.together)},
          {"last_speed", "", after_.empty() ? 0 : after_.back() / speed()},
          {"first_speed", "", after_.empty() ? 0 : after_.front() / speed()},
          {"swing_energy_error_max", "", energy_error_}};
}

void Cradle::draw(DrawList& list) const {
  WorldRun::draw(list);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const glm::vec3 ball = picture(place(body_of(world(), balls_[i])));
    const glm::vec3 top = picture({place_of(i), k_thread, 0});
    list.lines.push_back({.points = {top, ball}, .color = k_muted, .width = 2});
  }
}

void Cradle::draw_reference(DrawList& list) const {
  list.ground_height.reset();
}

}  // namespace

Scene cradle_scene() {
  return {
      .name = "cradle",
      .summary = "a row of balls that touch: one swings in, who swings out?",
      .methods = all_choices(),
      .default_methods = {"substeps", "worst_first"},
      .parameters = with_settings(
          {{"balls", "", "in the row", 5, 2, 50, true},
           {"lifted", "", "of those, at the left", 1, 1, 49, true},
           {"lift", "m", "how far those are pulled aside", 0.5, 1e-3, 1e3},
           {"gap", "m", "between balls at rest", 1e-5, 0, 1},
           {"restitution", "", "of the balls", 1, 0, 1},
           {"period", "s", "of a swing", 2, 1e-3, 1e3}},
          0),
      .dt = 1.0 / 60,
      .duration = 3,
      .camera = {.target = {0.5F, 0.55F, 0},
                 .distance = 2.4F,
                 .yaw = 0,
                 .pitch = 0.06F},
      .chart_metric = "momentum",
      .start = [](const Setup& setup) { return std::make_unique<Cradle>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
