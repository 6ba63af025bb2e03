// A heavy ball that is a little way inside a feather. No gravity.
#include <cmath>
#include <memory>

#include "chapters/05-penetration/least_motion.hpp"
#include "chapters/05-penetration/parts.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

// In sizes: the ball's radius, and half of the feather along x, y and z
constexpr double k_radius = 0.3;
constexpr glm::dvec3 k_half{0.5, 0.05, 0.1};

class FeatherAndBall : public OverlapRun {
 public:
  explicit FeatherAndBall(const Setup& setup);

 private:
  void add_metrics(std::vector<Metric>& metrics) const override;
  void draw_reference(DrawList& list) const override { list.ground_height.reset(); }
  double ball_mass() const { return parameter("mass"); }
  double feather_mass() const { return parameter("mass") / parameter("ratio"); }
};

FeatherAndBall::FeatherAndBall(const Setup& setup)
    : OverlapRun(setup, {.apart = {1.4F, 1}, .columns = 2, .mark = {-0.65F, 0, 0}}) {
  const double above = (k_radius + k_half.y - parameter("depth")) * size();
  const double along = parameter("along") * size();
  const Shape feather = Box{Vec3(size() * k_half)};
  const Shape ball = Sphere{Real(size() * k_radius)};
  const RigidBody bar = solid(feather_mass(), feather, {});
  const RigidBody weight = solid(ball_mass(), ball, {.position = {along, above, 0}});

  // Apart along the normal of a feather that has turned
  const Parting apart = ball_off_bar({.ball_mass = ball_mass(),
                                      .radius = size() * k_radius,
                                      .bar_mass = feather_mass(),
                                      .bar_inertia = 1 / double(bar.inverse_inertia.z),
                                      .half = size() * k_half.y,
                                      .along = along,
                                      .above = above});
  const glm::dvec3 normal(-std::sin(apart.turn), std::cos(apart.turn), 0);
  const glm::dquat turned = glm::angleAxis(apart.turn, glm::dvec3(0, 0, 1));
  add_body("feather", bar, feather, {-apart.bar * normal, turned});
  add_body("ball", weight, ball,
           {glm::dvec3(along, above, 0) + apart.ball * normal, {1, 0, 0, 0}});
}

// Formula 4, and what no push between the two can change
void FeatherAndBall::add_metrics(std::vector<Metric>& metrics) const {
  const double depth = parameter("depth") * size();
  const double masses = ball_mass() + feather_mass();
  const auto moved = [&](std::size_t i) {
    return glm::dvec3(body(i).position) - start_of(i).position;
  };
  const glm::dvec3 centre =
      (feather_mass() * moved(0) + ball_mass() * moved(1)) / masses;
  metrics.push_back({"feather_moved", "m", glm::length(moved(0))});
  metrics.push_back({"ball_moved", "m", glm::length(moved(1))});
  metrics.push_back({"ball_moved_formula_4", "m", depth * feather_mass() / masses});
  metrics.push_back({"centre_moved", "m", glm::length(centre)});
}

}  // namespace

Scene feather_and_ball_scene() {
  std::vector<Method> methods = all_choices();
  methods.push_back({"equal_shares", "each by half, whatever it weighs: wrong",
                     method_style(static_cast<int>(methods.size()))});
  std::vector<std::string> shown = all_names();
  shown.emplace_back("equal_shares");
  return {
      .name = "feather-and-ball",
      .summary = "a feather and a heavy ball overlap: which one moves?",
      .methods = methods,
      .default_methods = shown,
      .parameters = with_settings(
          {{"mass", "kg", "of the ball", 7, 1e-9, 1e9},
           {"ratio", "", "mass of the ball over the feather's", 1000, 1e-6, 1e6},
           {"depth", "", "of the overlap, in sizes", 0.04, 0, 0.4},
           {"along", "", "the feather, from its middle to the ball, in sizes", 0.3, 0,
            0.45}},
          {.iterations = 20, .slop = 0, .gravity = 0}),
      .presets = {{"central", "made for this chapter", {{"along", 0}}}},
      .dt = 1.0 / 60,
      .duration = 0.5,
      .camera = {.target = {0, 0.15F, 0}, .distance = 2, .yaw = 0.1F, .pitch = 0.1F},
      .chart_metric = "penetration",
      .start =
          [](const Setup& setup) { return std::make_unique<FeatherAndBall>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
