#include "common/graphics/camera.hpp"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

namespace timestep {
namespace {

constexpr glm::vec3 k_up{0, 1, 0};
constexpr float k_steepest = 1.55F;

/// From the target to the eye, unit length.
glm::vec3 toward_eye(const CameraPose& pose) {
  return {std::cos(pose.pitch) * std::sin(pose.yaw), std::sin(pose.pitch),
          std::cos(pose.pitch) * std::cos(pose.yaw)};
}

CameraPose pose_from(glm::vec3 position, glm::vec3 direction) {
  const glm::vec3 back = -glm::normalize(direction);
  CameraPose pose;
  pose.target = position - back * pose.distance;
  pose.pitch = std::asin(std::clamp(back.y, -1.0F, 1.0F));
  pose.yaw = std::atan2(back.x, back.z);
  return pose;
}

}  // namespace

Camera::Camera(const CameraPose& pose) : pose_(pose) {
  pose_.pitch = std::clamp(pose_.pitch, -k_steepest, k_steepest);
}

Camera::Camera(glm::vec3 position, glm::vec3 direction)
    : Camera(pose_from(position, direction)) {}

glm::vec3 Camera::position() const {
  return pose_.target + pose_.distance * toward_eye(pose_);
}

glm::mat4 Camera::view() const {
  return glm::lookAt(position(), pose_.target, k_up);
}

glm::mat4 Camera::projection(float aspect) const {
  return glm::perspective(pose_.vertical_fov, aspect, pose_.distance * 0.02F,
                          pose_.distance * 200);
}

std::optional<glm::vec2> Camera::project(glm::vec3 world, glm::vec2 size) const {
  const glm::vec4 clip = projection(size.x / size.y) * view() * glm::vec4(world, 1);
  if (!(clip.w > 0)) return std::nullopt;

  const glm::vec2 ndc = glm::vec2(clip) / clip.w;
  return glm::vec2{(ndc.x + 1) / 2 * size.x, (1 - ndc.y) / 2 * size.y};
}

CameraPose orbit(CameraPose pose, glm::vec2 drag, float height) {
  const float radians_per_pixel = glm::pi<float>() / height;
  pose.yaw -= drag.x * radians_per_pixel;
  pose.pitch =
      std::clamp(pose.pitch + drag.y * radians_per_pixel, -k_steepest, k_steepest);
  return pose;
}

CameraPose pan(CameraPose pose, glm::vec2 drag, float height) {
  // The target's plane is this many metres high in the picture
  const float metres = 2 * pose.distance * std::tan(pose.vertical_fov / 2);
  const glm::vec3 back = toward_eye(pose);
  const glm::vec3 right = glm::normalize(glm::cross(k_up, back));
  const glm::vec3 up = glm::cross(back, right);
  pose.target += (up * drag.y - right * drag.x) * (metres / height);
  return pose;
}

CameraPose zoom(CameraPose pose, float steps) {
  pose.distance = std::clamp(pose.distance * std::pow(0.9F, steps), 1e-3F, 1e6F);
  return pose;
}

}  // namespace timestep
