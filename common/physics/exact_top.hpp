/// @file
/// How a top stands and turns, in double, whatever the precision of the physics.
/// Source: chapter 3.
#pragma once

#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep::exact {

/// How a body is turned and turns: q, of length 1, takes its frame to the world's;
/// omega [rad/s] is in its own frame.
struct Turning {
  glm::dquat q;
  glm::dvec3 omega;
};

/// A turn [rad] about the third axis.
inline glm::dquat about_z(double angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

}  // namespace timestep::exact
