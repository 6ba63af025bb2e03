#include "common/graphics/ground_pass.hpp"

#include <cmath>

namespace timestep {
namespace {

constexpr float k_reach = 12;  // the ground's, in distances of the camera

}  // namespace

GroundPass::GroundPass(ResourceManager& resources)
    : background_(resources.load_shader("background.vert", "background.frag")),
      ground_(resources.load_shader("ground.vert", "ground.frag")),
      shadow_(resources.load_shader("ground.vert", "ground_shadow.frag")),
      square_(0, {}) {}

void GroundPass::draw_background(const Frame& frame) const {
  background_.set("world_from_clip", glm::inverse(frame.clip_from_world));
  glDisable(GL_DEPTH_TEST);
  square_.draw(1);
  glEnable(GL_DEPTH_TEST);
}

void GroundPass::draw_ground(const Frame& frame, float height) const {
  // Seen from 4 m to 40 m the main lines are metres apart; the finer ones fade in
  const float decades = std::log10(frame.pose.distance / 4);
  const float cell = std::pow(10.0F, std::floor(decades));
  const float nearness = 1 - (decades - std::floor(decades));
  ground_.set("cell", cell);
  ground_.set("fine_share", nearness * nearness);

  const glm::vec3 target = frame.pose.target;
  const float reach = k_reach * frame.pose.distance;
  ground_.set("clip_from_world", frame.clip_from_world);
  ground_.set("fade_center", target);
  ground_.set("reach", reach);
  ground_.set("center", glm::vec3(target.x, height, target.z));
  ground_.set("side", glm::vec3(reach, 0, 0));
  ground_.set("other_side", glm::vec3(0, 0, reach));
  square_.draw(1);
}

void GroundPass::draw_shadow(const Frame& frame, float height) const {
  // Where the light's rays through the shadow map's rectangle meet the ground
  const Light& light = frame.light;
  const auto slide = [&](glm::vec3 p, float to) {
    return p - light.toward_light * ((p.y - to) / light.toward_light.y);
  };
  set_lighting(shadow_, frame);
  shadow_.set("fade_center", frame.pose.target);
  shadow_.set("reach", k_reach * frame.pose.distance);
  shadow_.set("center", slide(light.center, height));
  shadow_.set("side", slide(light.right * light.half_size.x, 0));
  shadow_.set("other_side", slide(light.up * light.half_size.y, 0));
  square_.draw(1);
}

}  // namespace timestep
