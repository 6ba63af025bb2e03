// A cross product of unit vectors is as long as the sine of their angle, and rounding
// leaves it off by some u. Divided by a sine of 1e-8 that is an error of 1e-8 of the
// direction, which moves the overlap by 1e-8 of the boxes, in either direction: it may
// come out too small. So near parallels are left out. The normals at right angles to
// both faces are then as close to what they stood for, so nothing is lost but as much
// as that.
#include "chapters/04-contacts/exercises/4_2_fifteen_axes.hpp"

#include <algorithm>
#include <limits>

namespace timestep {

Real overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
             const Vec3& n) {
  const Vec3 on_a = point_in_world(pose_a, support(a, direction_in_body(pose_a, n)));
  const Vec3 on_b = point_in_world(pose_b, support(b, direction_in_body(pose_b, -n)));
  return glm::dot(n, on_a - on_b);
}

Real penetration_depth(const Box& a, const Pose& pose_a, const Box& b,
                       const Pose& pose_b) {
  constexpr Real k_parallel = 1e-8;
  Real least = std::numeric_limits<Real>::infinity();
  const auto try_axis = [&](const Vec3& n) {
    const Real length = glm::length(n);
    if (length < k_parallel) return;
    for (const Vec3& unit : {n / length, -n / length})
      least = std::min(least, overlap(a, pose_a, b, pose_b, unit));
  };

  const Mat3 edges_a = matrix_of(pose_a.orientation);
  const Mat3 edges_b = matrix_of(pose_b.orientation);
  for (const int i : {0, 1, 2}) {
    try_axis(edges_a[i]);
    try_axis(edges_b[i]);
    for (const int j : {0, 1, 2}) try_axis(glm::cross(edges_a[i], edges_b[j]));
  }
  return least;
}

}  // namespace timestep
