// Two blocks in the air with a push and a twist: they fall, collide, bounce and settle.
#include <cmath>
#include <memory>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

const glm::dvec3 k_size_1(0.9, 0.5, 0.7), k_size_2(0.5, 0.9, 0.6);  // [m]
constexpr double k_mass_1 = 1, k_mass_2 = 1;                        // [kg]

// A force [N] and a torque [N m], which act for k_push_time [s]
struct Push {
  glm::dvec3 force, torque;
};
const Push k_push_1{{3.5, 0, -0.5}, {-0.3, -0.4, -1}};
const Push k_push_2{{-2, 0, -0.5}, {0, 0.5, -0.6}};
constexpr double k_push_time = 0.2;

class TwoBlocks : public WorldRun {
 public:
  explicit TwoBlocks(const Setup& setup);
  void draw(DrawList& list) const override;

 private:
  void before_step() override;
  bool is_driven() const override { return time() < k_push_time + setup().dt; }
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  bool is_pushed() const { return time() < k_push_time; }
  void push(BodyHandle handle, const Push& push);
  void draw_push(DrawList& list, BodyHandle handle, const Push& push) const;

  BodyHandle first_{}, second_{};
  double rests_since_ = 0;  // [s]
};

TwoBlocks::TwoBlocks(const Setup& setup)
    : WorldRun(setup, {.lanes_apart = {4, 0, 0},
                       .force = 0.06F,
                       .impulse = 0.3F,
                       .normal = 0.25F,
                       .trails = true,
                       .contacts_as_dots = true}) {
  const double mu = parameter("friction"), e = parameter("restitution");
  const double height = parameter("height");
  add("floor", RigidBody{}, floor_collider(mu, e), k_body);
  first_ = add("first", box_body(k_mass_1, k_size_1, {-0.35, height, 0}),
               box_collider(k_size_1, mu, e), body_color(0));
  second_ = add("second", box_body(k_mass_2, k_size_2, {0.4, height + 1.1, 0.15}),
                box_collider(k_size_2, mu, e), body_color(1));
}

void TwoBlocks::push(BodyHandle handle, const Push& push) {
  RigidBody& body = body_of(world(), handle);
  const double strength = parameter("push");
  add_force(body, Vec3(strength * push.force));
  add_torque(body, Vec3(strength * push.torque));
}

void TwoBlocks::before_step() {
  if (!is_pushed()) return;
  push(first_, k_push_1);
  push(second_, k_push_2);
}

void TwoBlocks::after_step() {
  if (fastest() > 1e-4) rests_since_ = time();
}

std::vector<Metric> TwoBlocks::own_metrics() const {
  return {{"moves_until", "s", rests_since_}};
}

void TwoBlocks::draw_push(DrawList& list, BodyHandle handle, const Push& push) const {
  const glm::vec3 at = picture(place(body_of(world(), handle)));
  const float strength = static_cast<float>(parameter("push"));
  const auto arrow = [&](const glm::vec3& way, const char* name, const Color& color) {
    list.arrows.push_back({.from = at, .to = at + way, .color = color, .width = 5});
    list.labels.push_back({at + way, name, color});
  };
  arrow(0.35F * strength * glm::vec3(push.force), "force", k_force);
  arrow(1.3F * strength * glm::vec3(push.torque), "torque", k_velocity);
}

void TwoBlocks::draw(DrawList& list) const {
  WorldRun::draw(list);
  if (!is_pushed()) return;
  draw_push(list, first_, k_push_1);
  draw_push(list, second_, k_push_2);
}

}  // namespace

Scene two_blocks_scene() {
  return {
      .name = "two-blocks",
      .summary = "two blocks fall with a push and a twist, collide, bounce and settle",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"height", "m", "of the lower block's centre at the start", 1.6, 0.6, 1000},
           {"friction", "", "of all surfaces", 0.5, 0, 100},
           {"restitution", "", "of all surfaces", 0.7, 0, 1},
           {"push", "", "strength of the forces and torques", 1, 0, 10}}),
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.target = {0.1F, 1.45F, 0},
                 .distance = 4.5F,
                 .yaw = 0.3F,
                 .pitch = 0.12F},
      .chart_metric = "energy",
      .start = [](const Setup& setup) { return std::make_unique<TwoBlocks>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
