/// @file
/// The camera: from a pose to matrices and pixels, and what the mouse does to the pose.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "common/graphics/draw_list.hpp"

namespace timestep {

/// A perspective camera at a pose. World frame: y up, metres; view frame: x right, y
/// up, looking along -z; clip space as OpenGL has it (z from -1 to 1).
class Camera {
 public:
  explicit Camera(const CameraPose& pose);

  /// Looks from `position` along `direction`, which need not be of unit length and must
  /// not be vertical.
  Camera(glm::vec3 position, glm::vec3 direction);

  const CameraPose& pose() const { return pose_; }

  /// Where the eye is, world frame [m].
  glm::vec3 position() const;

  /// View from world.
  glm::mat4 view() const;

  /// Clip from view, for a picture `aspect` times as wide as high.
  glm::mat4 projection(float aspect) const;

  /// The pixel (x right, y down, from the top left corner) of a picture of `size`
  /// pixels in which a point of the world lands; none if it is not in front of the eye.
  std::optional<glm::vec2> project(glm::vec3 world, glm::vec2 size) const;

 private:
  CameraPose pose_;
};

/// The pose after the mouse moved by `drag` pixels in a picture `height` pixels high:
/// half a turn a picture height; the pitch stops just before the poles.
CameraPose orbit(CameraPose pose, glm::vec2 drag, float height);

/// The pose after a drag that moves the target with the mouse.
CameraPose pan(CameraPose pose, glm::vec2 drag, float height);

/// The pose after the wheel turned by `steps`; positive comes closer.
CameraPose zoom(CameraPose pose, float steps);

}  // namespace timestep
