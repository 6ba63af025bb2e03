/// @file
/// Where a shape is and how it is turned. Source: chapter 4.
#pragma once

#include "common/physics/quaternion.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// World from body: a point p of the body's frame is at position + orientation p.
struct Pose {
  Vec3 position{0};              ///< of the body's origin [m]
  Quat orientation{1, 0, 0, 0};  ///< of length one
};

/// Where a point [m] of the body is in the world.
inline Vec3 point_in_world(const Pose& pose, const Vec3& point) {
  return pose.position + pose.orientation * point;
}

/// Where a point [m] of the world is in the body's frame.
inline Vec3 point_in_body(const Pose& pose, const Vec3& point) {
  return glm::conjugate(pose.orientation) * (point - pose.position);
}

inline Vec3 direction_in_world(const Pose& pose, const Vec3& direction) {
  return pose.orientation * direction;
}

inline Vec3 direction_in_body(const Pose& pose, const Vec3& direction) {
  return glm::conjugate(pose.orientation) * direction;
}

/// The pose of B as A's frame sees it: A from B. The positions are subtracted first, so
/// that what is common to both, however far from the origin, rounds away nothing else.
inline Pose relative_pose(const Pose& a, const Pose& b) {
  return {point_in_body(a, b.position), glm::conjugate(a.orientation) * b.orientation};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
