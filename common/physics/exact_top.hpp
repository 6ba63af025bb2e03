/// @file
/// How a top stands and turns, and what is measured of it, in double, whatever the
/// precision of the physics. Source: chapter 3.
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

/// (3.13) Angular momentum [kg m²/s], world frame. I: principal moments [kg m²].
inline glm::dvec3 angular_momentum(const Turning& top, const glm::dvec3& I) {
  return top.q * (I * top.omega);
}

/// (3.15) Energy of the rotation [J].
inline double rotational_energy(const Turning& top, const glm::dvec3& I) {
  return glm::dot(top.omega, I * top.omega) / 2;
}

/// (3.36) The angle [rad], 0 to pi, of the one rotation that takes `from` to `to`.
inline double angle_between(const glm::dquat& from, const glm::dquat& to) {
  const glm::dquat d = glm::conjugate(from) * to;
  return 2 * std::atan2(glm::length(glm::dvec3(d.x, d.y, d.z)), std::abs(d.w));
}

/// The angle [rad] between two vectors; 0 if one of them is 0.
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A turn [rad] about the third axis.
inline glm::dquat about_z(double angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

}  // namespace timestep::exact
