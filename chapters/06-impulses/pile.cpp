// Boxes and balls that fall on each other askew, and come to rest as a pile.
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/chapter/random.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class Pile : public WorldRun {
 public:
  explicit Pile(const Setup& setup);
  CameraPose camera(const CameraPose& usual) const override;

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  double mean_speed() const;

  int side_;  // boxes of a layer, along each edge
  double rests_since_ = 0;
};

Pile::Pile(const Setup& setup)
    : WorldRun(setup, {}),
      side_(static_cast<int>(std::ceil(std::cbrt(parameter("n"))))) {
  const double mu = parameter("friction"), e = parameter("restitution");
  add("floor", RigidBody{}, floor_collider(mu, e), k_body);

  // In layers above each other, each turned and a little aside by chance
  Random random(static_cast<std::uint64_t>(parameter("seed")));
  const auto chance = [&] { return random.uniform(-0.5, 0.5); };
  for (int i = 0; i < static_cast<int>(parameter("n")); ++i) {
    const double middle = (side_ - 1) / 2.0;
    const glm::dvec3 cell(i % side_ - middle, 1 + i / (side_ * side_),
                          i / side_ % side_ - middle);
    const glm::dvec3 at = 1.5 * cell + 0.4 * glm::dvec3{chance(), 0, chance()};
    const glm::dquat turned =
        glm::normalize(glm::dquat{1, chance(), chance(), chance()});
    const bool is_ball = random.uniform(0, 1) < parameter("balls");
    RigidBody body = is_ball ? ball_body(1, 0.5, at) : box_body(1, glm::dvec3(1), at);
    body.orientation = Quat(turned);
    add(fmt::format("body {}", i + 1), body,
        is_ball ? ball_collider(0.5, mu, e) : box_collider(glm::dvec3(1), mu, e),
        body_color(static_cast<std::size_t>(i)));
  }
}

double Pile::mean_speed() const {
  double sum = 0;
  for (const RigidBody& body : world().bodies)
    sum += glm::length(glm::dvec3(body.velocity));
  return sum / parameter("n");
}

// At rest: slower than a fall of a tenth of a millimetre ends
void Pile::after_step() {
  const double slow = std::sqrt(2 * parameter("gravity") * 1e-4);
  if (mean_speed() > slow) rests_since_ = time();
}

std::vector<Metric> Pile::own_metrics() const {
  return {{"mean_speed", "m/s", mean_speed()}, {"moves_until", "s", rests_since_}};
}

CameraPose Pile::camera(const CameraPose& usual) const {
  CameraPose pose = WorldRun::camera(usual);
  const float side = static_cast<float>(side_);
  pose.target.y = 0.55F * side;
  pose.distance += 2.8F * side;
  return pose;
}

}  // namespace

Scene pile_scene() {
  return {
      .name = "pile",
      .summary = "boxes, and balls if you like, fall on each other askew",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings({{"n", "", "bodies", 100, 1, 2000, true},
                                   {"balls", "", "share of balls among them", 0, 0, 1},
                                   {"friction", "", "of all surfaces", 0.5, 0, 100},
                                   {"restitution", "", "of all surfaces", 0, 0, 1},
                                   {"seed", "", "of chance", 1, 0, 1e9, true}}),
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.distance = 2, .yaw = 0.6F, .pitch = 0.3F},
      .chart_metric = "mean_speed",
      .start = [](const Setup& setup) { return std::make_unique<Pile>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
