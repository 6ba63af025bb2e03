// Below, the overlap is that of two balls around the boxes, and three of the fifteen
// axes are looked at, in one direction each. Mend both.
//
// Hints: along n, A reaches as far as its support point in direction n, B back as far
// as its own in direction -n. `support` works in a box's frame: `direction_in_body` and
// `point_in_world` are in pose.hpp.
//
// The directions that matter are the three face normals of either box and the nine
// cross products of their edges. A normal serves with both its signs. A cross product
// of parallel edges is zero, or what rounding leaves of zero: it says nothing, and made
// one metre long it would say nonsense. Which lengths are too short?
#include "chapters/04-contacts/exercises/4_2_fifteen_axes.hpp"

#include <algorithm>

namespace timestep {

Real overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
             const Vec3& n) {
  return glm::length(a.half_extents) + glm::length(b.half_extents)
         - glm::dot(n, pose_b.position - pose_a.position);
}

Real penetration_depth(const Box& a, const Pose& pose_a, const Box& b,
                       const Pose& pose_b) {
  Real least = overlap(a, pose_a, b, pose_b, direction_in_world(pose_a, {1, 0, 0}));
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const Vec3 n = direction_in_world(pose_a, axis);
    least = std::min(least, overlap(a, pose_a, b, pose_b, n));
  }
  return least;
}

}  // namespace timestep
