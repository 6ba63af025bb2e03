// A block on a slope: it stays below the angle of friction, and slides above it. Pushed
// off the slope's axis, it tells friction in a circle from friction in a square.
#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_sliding.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

// [m] Flat, so that it slides before it tips at every friction up to 4
const glm::dvec3 k_size(0.6, 0.15, 0.6);

class Ramp : public WorldRun {
 public:
  explicit Ramp(const Setup& setup);
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  glm::dvec3 in_world(const glm::dvec2& along) const;
  glm::dvec2 along() const;
  glm::dvec2 start_velocity() const;
  exact::Incline incline() const;
  glm::dvec2 exact_way() const;

  BodyHandle block_{};
  double angle_;
  double error_max_ = 0;
  glm::dvec2 velocity_before_{0}, acceleration_{0};
};

Ramp::Ramp(const Setup& setup)
    : WorldRun(setup, {.force = 0.08F, .trails = true, .contacts_as_dots = true}),
      angle_(parameter("angle")) {
  world().settings.use_pyramid = parameter("use_pyramid") != 0;
  const double mu = parameter("friction");
  RigidBody slope;
  slope.orientation = Quat(glm::angleAxis(-angle_, glm::dvec3(0, 0, 1)));
  add("slope", slope, floor_collider(mu, 0), k_body);

  RigidBody block = box_body(1, k_size, in_world(glm::dvec2(0)));
  block.orientation = slope.orientation;
  block.velocity = Vec3(in_world(start_velocity()) - in_world(glm::dvec2(0)));
  block_ = add("block", block, box_collider(k_size, mu, 0), body_color(0));
  velocity_before_ = start_velocity();
}

// Where the block's centre is after a way down the slope and across it [m]
glm::dvec3 Ramp::in_world(const glm::dvec2& along) const {
  const double s = std::sin(angle_), c = std::cos(angle_);
  return along.x * glm::dvec3(c, -s, 0) + along.y * glm::dvec3(0, 0, 1)
         + k_size.y / 2 * glm::dvec3(s, c, 0);
}

glm::dvec2 Ramp::along() const {
  const glm::dvec3 x = place(body_of(world(), block_));
  return {x.x * std::cos(angle_) - x.y * std::sin(angle_), x.z};
}

glm::dvec2 Ramp::start_velocity() const {
  const double direction = parameter("direction");
  return parameter("speed") * glm::dvec2(std::cos(direction), std::sin(direction));
}

exact::Incline Ramp::incline() const {
  const double mu = parameter("friction");
  return {angle_, mu, mu, parameter("gravity")};
}

// With Coulomb's cone, whatever the solver uses
glm::dvec2 Ramp::exact_way() const {
  return exact::across_incline(incline(), start_velocity(), time()).x;
}

void Ramp::after_step() {
  error_max_ = std::max(error_max_, glm::distance(along(), exact_way()));
  const glm::dvec3 v(body_of(world(), block_).velocity);
  const glm::dvec2 now(v.x * std::cos(angle_) - v.y * std::sin(angle_), v.z);
  if (steps() > 0) acceleration_ = (now - velocity_before_) / setup().dt;
  velocity_before_ = now;
}

std::vector<Metric> Ramp::own_metrics() const {
  const glm::dvec2 way = along(), exact = exact_way();
  const bool slides = exact::slides_from_rest(incline());
  return {
      {"way_error", "m", glm::distance(way, exact)},
      {"way_error_max", "m", error_max_},
      {"way_down", "m", way.x},
      {"way_across", "m", way.y},
      {"way_down_exact", "m", exact.x},
      {"way_across_exact", "m", exact.y},
      {"acceleration", "m/s²", acceleration_.x},
      {"acceleration_from_rest_exact", "m/s²",
       slides ? exact::sliding_acceleration(incline()) : 0},
      {"angle_of_friction", "rad", exact::threshold_angle(parameter("friction"))},
  };
}

void Ramp::draw_reference(DrawList& list) const {
  constexpr float k_thick = 0.06F, k_long = 2.2F, k_wide = 1.2F;
  const glm::mat4 turned =
      glm::rotate(glm::mat4(1), -static_cast<float>(angle_), glm::vec3(0, 0, 1));
  const glm::mat4 slab =
      glm::scale(glm::translate(turned, glm::vec3(k_long - 0.7F, -k_thick, 0)),
                 glm::vec3(k_long, k_thick, k_wide));
  list.shapes.push_back({ShapeKind::box, slab, k_body});

  const glm::dvec3 up(std::sin(angle_), std::cos(angle_), 0);
  const glm::vec3 at(in_world(exact_way()) + k_size.y / 2 * up);
  list.markers.push_back({.position = at, .style = reference_style(), .size = 16});
  list.legend.push_back({reference_style(), "exact"});
  list.ground_height.reset();
}

// On the middle of the slab
CameraPose Ramp::camera(const CameraPose& usual) const {
  CameraPose pose = WorldRun::camera(usual);
  pose.target = glm::vec3(in_world({1.4, 0.2}));
  return pose;
}

}  // namespace

Scene ramp_scene() {
  return {
      .name = "ramp",
      .summary = "a block on a slope: when it slides, how fast, and pushed askew",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"angle", "rad", "of the slope", 0.5, 0, 1.55},
           {"friction", "", "of block and slope", 0.4, 0, 100},
           {"speed", "m/s", "of the block at the start", 0, 0, 1000},
           {"direction", "rad", "of that speed: 0 is downhill", 0, -3.2, 3.2},
           {"use_pyramid", "", "1: friction in a square, 0: in a circle", 0, 0, 1,
            true}}),
      .presets = {{"threshold", "made for this chapter", {{"angle", 0.38}}},
                  {"askew",
                   "made for this chapter",
                   {{"angle", 0}, {"speed", 5}, {"direction", 0.5}}}},
      .dt = 1.0 / 60,
      .duration = 1.8,
      .camera = {.distance = 4.3F, .yaw = 0.35F, .pitch = 0.3F},
      .chart_metric = "way_error",
      .start = [](const Setup& setup) { return std::make_unique<Ramp>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
