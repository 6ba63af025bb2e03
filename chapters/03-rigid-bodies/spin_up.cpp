// A wheel on its axis under a steady torque: the plainest rotation there is.
#include <cmath>
#include <numbers>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "chapters/03-rigid-bodies/parts.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/rigid_body.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

constexpr float k_apart = 2.6F;

// The angle [rad] and the angular velocity [rad/s] about the axis
struct Turned {
  double angle, omega;
};

class SpinUp : public BodyRun {
 public:
  explicit SpinUp(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override {
    return camera_for_lanes(usual, setup(), k_apart);
  }

 private:
  void advance() override;
  Turned exact_now() const;

  double inertia_, torque_, damping_;
  RigidBody wheel_;
  double angle_ = 0;  // whole turns counted
};

SpinUp::SpinUp(const Setup& setup)
    : BodyRun(setup),
      inertia_(parameter("inertia")),
      torque_(parameter("torque")),
      damping_(parameter("damping")) {
  // A disc: half of the moment about its axis belongs to each diameter
  const double I = inertia_;
  wheel_.inverse_inertia = Vec3(glm::dvec3(2 / I, 2 / I, 1 / I));
  wheel_.inverse_mass = 1;
}

void SpinUp::advance() {
  add_torque(wheel_, {0, 0, Real(torque_)});
  integrate(wheel_, method().step, Real(setup().dt));
  damp(wheel_, 1, Real(damping_), Real(setup().dt));
}

void SpinUp::observe() {
  const glm::dquat q(wheel_.orientation);
  const double here = 2 * std::atan2(q.z, q.w);
  angle_ += std::remainder(here - angle_, 2 * std::numbers::pi);
}

// omega' = tau / I + ln(damping) omega
Turned SpinUp::exact_now() const {
  const double t = time();
  const double alpha = torque_ / inertia_;
  const double rate = -std::log(damping_);
  if (rate * t < 1e-9) return {alpha * t * t / 2, alpha * t};
  const double gone = -std::expm1(-rate * t);
  return {alpha / rate * (t - gone / rate), alpha / rate * gone};
}

std::vector<BodyState> SpinUp::bodies() const {
  return {{.name = "wheel",
           .orientation = glm::dquat(wheel_.orientation),
           .angular_velocity = glm::dvec3(wheel_.angular_velocity)}};
}

std::vector<Metric> SpinUp::metrics() const {
  const Turned exact = exact_now();
  const double omega = static_cast<double>(wheel_.angular_velocity.z);
  return {{"angle_error", "rad", angle_ - exact.angle},
          {"angular_velocity_error", "rad/s", omega - exact.omega},
          {"angle", "rad", angle_},
          {"angle_exact", "rad", exact.angle},
          {"angular_velocity", "rad/s", omega},
          {"angular_velocity_exact", "rad/s", exact.omega}};
}

// A wheel of radius 1 with a spoke that shows how far it has turned
void draw_wheel(DrawList& list, const glm::vec3& at, double angle, const Color& color) {
  const glm::dquat turned = glm::angleAxis(angle, glm::dvec3(0, 0, 1));
  const glm::mat4 wheel =
      glm::rotate(placed(at, turned), glm::half_pi<float>(), glm::vec3(1, 0, 0));
  list.shapes.push_back(
      {ShapeKind::cylinder, glm::scale(wheel, glm::vec3(1, 0.12F, 1)), k_body});
  const glm::vec3 rim = at + glm::vec3(std::cos(angle), std::sin(angle), 0.14F);
  list.lines.push_back(
      {.points = {at + glm::vec3(0, 0, 0.14F), rim}, .color = color, .width = 5});
  list.balls.push_back({rim, 0.09F, color});
}

void SpinUp::draw(DrawList& list) const {
  const glm::vec3 at = place_of_lane(setup(), k_apart);
  draw_wheel(list, at, angle_, setup().style.color);
}

void SpinUp::draw_reference(DrawList& list) const {
  const glm::vec3 at = place_of_exact(setup(), k_apart);
  draw_wheel(list, at, exact_now().angle, k_ink);
  list.labels.push_back({at - glm::vec3(0.3F, 1.35F, 0), "exact", k_ink});
  list.ground_height.reset();
}

}  // namespace

Scene spin_up_scene() {
  return {
      .name = "spin-up",
      .summary = "a wheel under a steady torque: angle and speed, with or without drag",
      .methods = all_choices(),
      .default_methods = {"listing_3", "momentum", "splitting"},
      .parameters = {{"inertia", "kg m²", "about the axis", 0.5, 1e-12, 1e12},
                     {"torque", "N m", "about the axis", 1, -1e12, 1e12},
                     {"damping", "", "share of the speed that is left after a second",
                      1, 1e-3, 1}},
      .duration = 5,
      .camera = {.target = {0, 0, 0}, .distance = 6.5F, .yaw = 0, .pitch = 0},
      .chart_metric = "angle_error",
      .start = [](const Setup& setup) { return std::make_unique<SpinUp>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
