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
  const MinkowskiDifference& d = difference;
  SupportPoint p;
  p.vertex_a = near.vertex_a;
  p.vertex_b = near.vertex_b;
  p.a = d.a.core_support(d.a.shape, direction, p.vertex_a);
  p.b = d.b.core_support(d.b.shape, -direction * d.a_from_b, p.vertex_b);
  p.w = difference_at(d, p.a, p.b);
  return p;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
