#include "common/physics/minkowski.hpp"

#include <algorithm>
#include <cmath>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// The least power of two above size [m], or near the ends of Real's range the last one
// whose inverse is finite
Real unit_for(Real size) {
  constexpr int k_last = std::numeric_limits<Real>::max_exponent - 2;
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(Real(1), std::clamp(exponent, -k_last, k_last));
}

}  // namespace

MinkowskiDifference minkowski_difference(const Convex& a, const Pose& pose_a,
                                         const Convex& b, const Pose& pose_b) {
  const Pose b_in_a = relative_pose(pose_a, pose_b);
  const Vec3& t = b_in_a.position;
  const Real far_b = length_of(t) + b.reach;
  const Real turn = glm::dot(b_in_a.orientation, b_in_a.orientation);
  if (!std::isfinite(a.reach + far_b + turn + a.radius + b.radius))
    return {a, b, Mat3(1), Vec3(0), 0, 0};
  const Real unit = unit_for(std::max(a.reach, far_b));
  return {a, b, matrix_of(b_in_a.orientation), t / unit, unit, 1 / unit};
}

Vec3 difference_at(const MinkowskiDifference& difference, const Vec3& a,
                   const Vec3& b) {
  const MinkowskiDifference& d = difference;
  return d.a_from_b * (d.scale * b) + d.offset - d.scale * a;
}

SupportPoint support(const MinkowskiDifference& difference, const Vec3& direction,
                     const SupportPoint& near) {
  SupportPoint point;
  find_support(difference, direction, near, point);
  return point;
}

void find_support(const MinkowskiDifference& difference, const Vec3& direction,
                  const SupportPoint& near, SupportPoint& point) {
  const MinkowskiDifference& d = difference;
  point.vertex_a = near.vertex_a;
  point.vertex_b = near.vertex_b;
  point.a = d.a.core_support(d.a.shape, direction, point.vertex_a);
  point.b = d.b.core_support(d.b.shape, -direction * d.a_from_b, point.vertex_b);
  point.w = difference_at(d, point.a, point.b);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
