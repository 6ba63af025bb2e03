// Balls dropped side by side, from one that sticks to one that loses nothing.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_bounce.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

constexpr double k_mass = 1, k_apart = 3;  // [kg], radii between two balls' centres

class Bounce : public WorldRun {
 public:
  explicit Bounce(const Setup& setup);
  void draw_reference(DrawList& list) const override;

 private:
  struct Dropped {
    exact::BouncingBall exact;
    double x;  // [m]
    BodyHandle handle;
  };

  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  double height_of(const Dropped& ball) const;
  double energy_error() const;

  double radius_;
  std::vector<Dropped> balls_;
  double error_ = 0, worst_error_ = 0, worst_energy_error_ = 0;
};

Bounce::Bounce(const Setup& setup)
    : WorldRun(setup, {.scale = static_cast<float>(1 / setup.parameters.at("height")),
                       .lanes_apart = {0, 0, -0.6F}}),
      radius_(parameter("radius")) {
  add("floor", RigidBody{}, floor_collider(0.5, 0), k_body);
  const int count = static_cast<int>(parameter("balls"));
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 1;
    const double e = std::lerp(parameter("lowest"), parameter("highest"), share);
    const double x = k_apart * radius_ * (i - (count - 1) / 2.0);
    const RigidBody body =
        ball_body(k_mass, radius_, {x, radius_ + parameter("height"), 0});
    const auto handle = add(fmt::format("ball {}", i + 1), body,
                            ball_collider(radius_, 0.5, e), body_color(0));

    // What Real makes of the numbers is what is exact
    balls_.push_back(
        {{parameter("height"), double(Real(e)), parameter("gravity")}, x, handle});
  }
}

// [m] of the lowest point
double Bounce::height_of(const Dropped& ball) const {
  return place(body_of(world(), ball.handle)).y - radius_;
}

// Of the last ball, as a share of what it had
double Bounce::energy_error() const {
  const Dropped& last = balls_.back();
  const auto energy = [&](double height, double v) {
    return last.exact.g * height + v * v / 2;
  };
  const exact::Coordinate now = exact::bouncing_ball(last.exact, time());
  const RigidBody& body = body_of(world(), last.handle);
  return (energy(height_of(last), glm::length(glm::dvec3(body.velocity)))
          - energy(now.x, now.v))
         / energy(last.exact.height, 0);
}

void Bounce::after_step() {
  error_ = 0;
  for (const Dropped& ball : balls_) {
    const double exact = exact::bouncing_ball(ball.exact, time()).x;
    error_ = std::max(error_, std::abs(height_of(ball) - exact));
  }
  worst_error_ = std::max(worst_error_, error_);
  worst_energy_error_ = std::max(worst_energy_error_, std::abs(energy_error()));
}

std::vector<Metric> Bounce::own_metrics() const {
  return {{"height_error", "m", error_},
          {"height_error_max", "m", worst_error_},
          {"energy_error", "", energy_error()},
          {"energy_error_max", "", worst_energy_error_}};
}

void Bounce::draw_reference(DrawList& list) const {
  const float scale = static_cast<float>(1 / parameter("height"));
  const auto at = [&](const Dropped& ball, double height) {
    return scale * glm::vec3(ball.x, height + radius_, 0);
  };
  std::vector<glm::vec3> starts, rebounds;
  for (const Dropped& ball : balls_) {
    starts.push_back(at(ball, ball.exact.height));
    rebounds.push_back(at(ball, exact::apex_height(ball.exact, 1)));
    const double now = exact::bouncing_ball(ball.exact, time()).x;
    list.markers.push_back(
        {.position = at(ball, now) + glm::vec3(0, 0, 1.05F * scale * float(radius_)),
         .style = reference_style(),
         .size = 16});
    list.labels.push_back({at(ball, -2.2 * radius_) - glm::vec3(0.08F, 0, 0),
                           fmt::format("e = {:.2g}", ball.exact.e), k_ink});
  }
  list.lines.push_back({.points = starts, .color = k_muted, .dash = Dash::dotted});
  list.lines.push_back({.points = rebounds, .color = k_muted, .dash = Dash::dashed});
  list.legend.push_back({reference_style(), "exact"});
}

}  // namespace

Scene bounce_scene() {
  return {
      .name = "bounce",
      .summary = "balls side by side, of restitution 0 to 1, against what is exact",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"balls", "", "how many", 6, 1, 100, true},
           {"lowest", "", "restitution of the first ball", 0, 0, 1},
           {"highest", "", "of the last one; evenly between", 1, 0, 1},
           {"height", "m", "of the lowest points at the start", 1, 1e-6, 1e6},
           {"radius", "m", "of the balls", 0.1, 1e-6, 1e6}}),
      .dt = 1.0 / 60,
      .duration = 2,
      .camera = {.target = {0, 0.55F, 0}, .distance = 1.75F, .yaw = 0, .pitch = 0.08F},
      .chart_metric = "height_error",
      .start = [](const Setup& setup) { return std::make_unique<Bounce>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
