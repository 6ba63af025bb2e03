// A ball that is set down sliding, with a spin of its own or none: friction brakes it
// and turns it until it rolls.
#include <algorithm>
#include <cmath>
#include <memory>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_cue_ball.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class SlideToRoll : public WorldRun {
 public:
  explicit SlideToRoll(const Setup& setup);
  void draw_reference(DrawList& list) const override;

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  exact::Ball exact_ball() const;
  exact::BallMotion exact_start() const;
  exact::BallMotion exact_now() const;
  double slip() const;

  BodyHandle ball_{};
  double velocity_error_max_ = 0, rolling_time_ = 0;
  bool rolls_ = false;
};

// The closed form has z upwards
glm::dvec3 in_scene(const glm::dvec3& v) {
  return {v.x, v.z, -v.y};
}

// The ball is 0.2 m in radius in the picture
SlideToRoll::SlideToRoll(const Setup& setup)
    : WorldRun(setup, {.scale = 0.2F / float(setup.parameters.at("radius")),
                       .force = 0.2F / float(setup.parameters.at("gravity")),
                       .trails = true,
                       .rings = true}) {
  const double mu = parameter("friction"), radius = parameter("radius");
  add("floor", RigidBody{}, floor_collider(mu, 0), k_body);
  RigidBody ball = ball_body(1, radius, {0, radius, 0});
  ball.velocity = Vec3(in_scene(exact_start().v));
  ball.angular_velocity = Vec3(in_scene(exact_start().omega));
  ball_ = add("ball", ball, ball_collider(radius, mu, 0), body_color(0));
}

exact::Ball SlideToRoll::exact_ball() const {
  return {.mass = 1,
          .radius = parameter("radius"),
          .k = 0.4,
          .mu = parameter("friction"),
          .g = parameter("gravity")};
}

exact::BallMotion SlideToRoll::exact_start() const {
  return {{0, 0, 0},
          {parameter("speed"), 0, 0},
          {0, parameter("topspin"), parameter("side_spin")}};
}

exact::BallMotion SlideToRoll::exact_now() const {
  return exact::slide_then_roll(exact_ball(), exact_start(), time());
}

// Speed of the ball's lowest point [m/s]
double SlideToRoll::slip() const {
  const RigidBody& ball = body_of(world(), ball_);
  const glm::dvec3 arm(0, -parameter("radius"), 0);
  const glm::dvec3 v =
      glm::dvec3(ball.velocity) + glm::cross(glm::dvec3(ball.angular_velocity), arm);
  return std::hypot(v.x, v.z);
}

void SlideToRoll::after_step() {
  const glm::dvec3 v(body_of(world(), ball_).velocity);
  const double error = glm::distance(v, in_scene(exact_now().v));
  velocity_error_max_ = std::max(velocity_error_max_, error);

  // Rolling is a slip that no longer counts: a thousandth of that at the start
  const double at_start = glm::length(exact::slip(exact_ball(), exact_start()));
  if (rolls_ || slip() > 1e-3 * at_start) return;
  rolls_ = true;
  rolling_time_ = time();
}

std::vector<Metric> SlideToRoll::own_metrics() const {
  const exact::BallMotion exact = exact_now();
  const double rolling = exact::time_until_rolling(exact_ball(), exact_start());
  const RigidBody& ball = body_of(world(), ball_);
  const glm::dvec3 v(ball.velocity), omega(ball.angular_velocity);
  return {
      {"velocity_error", "m/s", glm::distance(v, in_scene(exact.v))},
      {"velocity_error_max", "m/s", velocity_error_max_},
      {"spin_error", "rad/s", glm::distance(omega, in_scene(exact.omega))},
      {"speed", "m/s", glm::length(v)},
      {"speed_exact", "m/s", glm::length(exact.v)},
      {"slip", "m/s", slip()},
      {"rolling_time", "s", rolling_time_},
      {"rolling_time_exact", "s", std::isfinite(rolling) ? rolling : 0},
  };
}

void SlideToRoll::draw_reference(DrawList& list) const {
  const glm::dvec3 top(0, 2 * parameter("radius"), 0);
  const glm::vec3 at = picture(in_scene(exact_now().x) + top);
  list.markers.push_back({.position = at, .style = reference_style(), .size = 16});
  list.legend.push_back({reference_style(), "exact"});
}

}  // namespace

Scene slide_to_roll_scene() {
  return {
      .name = "slide-to-roll",
      .summary = "a ball slides until friction has made it roll",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"radius", "m", "of the ball", 0.2, 1e-6, 1e6},
           {"speed", "m/s", "of the ball at the start", 2, 0, 1000},
           {"topspin", "rad/s", "at the start; below 0 it is backspin", 0, -1e4, 1e4},
           {"side_spin", "rad/s", "at the start, about the vertical", 0, -1e4, 1e4},
           {"friction", "", "of ball and floor", 0.2, 0, 100}}),
      .presets = {{"draw", "made for this chapter", {{"topspin", -40}}}},
      .dt = 1.0 / 60,
      .duration = 1,
      .camera = {.target = {0.8F, 0.25F, 0},
                 .distance = 2.1F,
                 .yaw = 0.15F,
                 .pitch = 0.2F},
      .chart_metric = "slip",
      .start = [](const Setup& setup) { return std::make_unique<SlideToRoll>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
