// A fast body and a thin wall: between two steps it may be on the one side and then on
// the other. Flight is looked ahead along; spin is not wholly.
#include <algorithm>
#include <memory>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class ThinWall : public WorldRun {
 public:
  explicit ThinWall(const Setup& setup);

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;

  BodyHandle body_{};
  double farthest_ = 0;
};

ThinWall::ThinWall(const Setup& setup)
    : WorldRun(setup, {.trails = true, .contacts_as_dots = true}) {
  const double mu = parameter("friction"), e = parameter("restitution");
  const glm::dvec3 wall(parameter("thickness"), 2, 2), stick(0.8, 0.1, 0.1);
  add("wall", RigidBody{}, box_collider(wall, mu, e), k_body);

  const glm::dvec3 start(-parameter("away"), 0, 0);
  const bool is_stick = parameter("stick") != 0;
  RigidBody body = is_stick ? box_body(1, stick, start) : ball_body(1, 0.1, start);
  body.velocity.x = Real(parameter("speed"));
  body.angular_velocity.z = Real(parameter("spin"));
  body_ = add(is_stick ? "stick" : "ball", body,
              is_stick ? box_collider(stick, mu, e) : ball_collider(0.1, mu, e),
              body_color(0));
}

void ThinWall::after_step() {
  const double x = place(body_of(world(), body_)).x;
  farthest_ = steps() == 0 ? x : std::max(farthest_, x);
}

std::vector<Metric> ThinWall::own_metrics() const {
  const RigidBody& body = body_of(world(), body_);
  return {{"tunnelled", "", farthest_ > parameter("thickness") / 2 ? 1.0 : 0.0},
          {"farthest", "m", farthest_},
          {"speed_after", "m/s", static_cast<double>(body.velocity.x)}};
}

}  // namespace

Scene thin_wall_scene() {
  return {
      .name = "thin-wall",
      .summary = "a fast or spinning body flies at a thin wall",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters =
          with_settings({{"speed", "m/s", "towards the wall", 100, 0, 1e6},
                         {"spin", "rad/s", "in the plane of the picture", 0, -1e4, 1e4},
                         {"stick", "", "0: a ball, 1: a stick of 0.8 m", 0, 0, 1, true},
                         {"thickness", "m", "of the wall", 0.01, 1e-6, 1},
                         {"away", "m", "from the wall at the start", 1.5, 0.5, 100},
                         {"friction", "", "of all surfaces", 0.5, 0, 100},
                         {"restitution", "", "of all surfaces", 0.5, 0, 1}}),
      .dt = 1.0 / 60,
      .duration = 0.1,
      .camera = {.target = {-0.6F, 0, 0}, .distance = 4, .yaw = 0.3F, .pitch = 0.2F},
      .chart_metric = "speed_after",
      .start = [](const Setup& setup) { return std::make_unique<ThinWall>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
