/// @file
/// Orientations: unit quaternions w, x, y, z that take vectors of the body frame to the
/// world frame, and two ways to turn one a little further. Source: chapter 3.
#pragma once

#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

using Quat = glm::qua<Real>;
using Mat3 = glm::mat<3, 3, Real>;

/// (3.3) The rotation by |angle| [rad] about the axis that `angle` points along: the
/// exponential map.
inline Quat rotation_by(const Vec3& angle) {
  const Real size = glm::length(angle);
  const Real s = size > 0 ? std::sin(size / 2) / size : Real(0.5);
  return {std::cos(size / 2), s * angle};
}

/// (3.4) q turned for dt [s] at the angular velocity omega [rad/s, world frame] as
/// Listing 3 does it: along the tangent, then back to length one. It turns by
/// 2 atan(|omega| dt / 2) in place of |omega| dt.
inline Quat add_and_normalise(const Quat& q, const Vec3& omega, Real dt) {
  return glm::normalize(q + Quat(0, omega) * q * (dt / 2));
}

/// (3.4) The same with omega [rad/s] in the body frame.
inline Quat add_and_normalise_in_body(const Quat& q, const Vec3& omega, Real dt) {
  return glm::normalize(q + q * Quat(0, omega) * (dt / 2));
}

/// v turned by q, whatever the length of q. Rounding leaves a normalised q a little too
/// long on average; where a vector goes there and back in every step, q * v would make
/// it longer and longer.
inline Vec3 turned_by(const Quat& q, const Vec3& v) {
  const Vec3 u(q.x, q.y, q.z);
  const Vec3 c = glm::cross(u, v);
  return v + 2 / glm::dot(q, q) * (q.w * c + glm::cross(u, c));
}

/// The matrix whose columns are the body's axes in the world frame.
inline Mat3 matrix_of(const Quat& q) {
  return glm::mat3_cast(q);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
