#include "common/graphics/frame.hpp"

#include <algorithm>
#include <limits>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace timestep {
namespace {

constexpr glm::vec3 k_toward_light{0.46F, 0.80F, 0.38F};

struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void add(glm::vec3 center, glm::vec3 reach) {
    low = glm::min(low, center - reach);
    high = glm::max(high, center + reach);
  }
  bool empty() const { return !(low.x <= high.x); }
};

/// Adds a box from `low` to `high` under a transform.
void add_box(Bounds& bounds, const glm::mat4& world_from_box, glm::vec3 low,
             glm::vec3 high) {
  const glm::vec3 half = (high - low) / 2.0F;
  const glm::vec3 reach = glm::abs(glm::vec3(world_from_box[0])) * half.x
                          + glm::abs(glm::vec3(world_from_box[1])) * half.y
                          + glm::abs(glm::vec3(world_from_box[2])) * half.z;
  bounds.add(world_from_box * glm::vec4((low + high) / 2.0F, 1), reach);
}

Bounds casters(const DrawList& list) {
  Bounds bounds;
  for (const ShapeInstance& shape : list.shapes) {
    add_box(bounds, shape.world_from_shape, glm::vec3(-1), glm::vec3(1));
  }
  for (const MeshInstance& instance : list.meshes) {
    Bounds mesh;
    for (const glm::vec3& p : instance.mesh->positions) mesh.add(p, glm::vec3(0));
    if (!mesh.empty()) add_box(bounds, instance.world_from_mesh, mesh.low, mesh.high);
  }
  for (const Ball& ball : list.balls) bounds.add(ball.center, glm::vec3(ball.radius));
  return bounds;
}

}  // namespace

Light light_for(const DrawList& list, const CameraPose& pose, int side) {
  Light light;
  light.toward_light = glm::normalize(k_toward_light);
  light.right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), light.toward_light));
  light.up = glm::cross(light.toward_light, light.right);
  light.texel = 1.0F / static_cast<float>(side);
  const Bounds bounds = casters(list);
  if (bounds.empty()) return light;

  // The casters' box in the light's frame, cut down to what the camera shows well
  const glm::mat3 world_from_light{light.right, light.up, light.toward_light};
  const glm::mat3 light_from_world = glm::transpose(world_from_light);
  Bounds seen;
  add_box(seen, glm::mat4(light_from_world), bounds.low, bounds.high);
  const glm::vec3 target = light_from_world * pose.target;
  const glm::vec3 reach(2.5F * pose.distance);
  const glm::vec3 low = glm::clamp(seen.low, target - reach, target + reach);
  const glm::vec3 high = glm::clamp(seen.high, target - reach, target + reach);

  // A margin for soft edges; the lamp stands above everything, far things are clamped
  const glm::vec3 half = (high - low) * 0.52F + 1e-3F * pose.distance;
  light.center = world_from_light * ((low + high) / 2.0F);
  light.half_size = half;
  light.metre = 2 * std::max(half.x, half.y) * light.texel;
  light.clip_from_world =
      glm::ortho(-half.x, half.x, -half.y, half.y, 0.0F, 3 * half.z)
      * glm::lookAt(light.center + light.toward_light * half.z, light.center, light.up);
  return light;
}

void set_lighting(const Shader& shader, const Frame& frame) {
  // From clip space, -1 to 1, to the map's places and depths, 0 to 1
  const glm::mat4 map_from_clip = glm::translate(glm::mat4(1), glm::vec3(0.5F))
                                  * glm::scale(glm::mat4(1), glm::vec3(0.5F));
  shader.set("clip_from_world", frame.clip_from_world);
  shader.set("eye", frame.eye);
  shader.set("toward_light", frame.light.toward_light);
  shader.set("shadow_from_world", map_from_clip * frame.light.clip_from_world);
  shader.set("shadow_map", 1);
  shader.set("shadow_texel", frame.light.texel);
  shader.set("shadow_metre", frame.light.metre);
}

}  // namespace timestep
