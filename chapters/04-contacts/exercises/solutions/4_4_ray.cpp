// Each plane cuts a part off the ray, and what is left of it is one interval: from the
// last plane that it comes in through to the first that it goes out through. If that is
// empty the ray misses. It is SAT's idea in one dimension, and Cyrus and Beck's way of
// clipping lines (1978).
#include "chapters/04-contacts/exercises/4_4_ray.hpp"

#include <algorithm>
#include <limits>

namespace timestep {

std::optional<RayHit> cast_ray(const ConvexHull& hull, const Vec3& origin,
                               const Vec3& direction) {
  RayHit in{0, Vec3(0)};
  Real out = std::numeric_limits<Real>::infinity();
  for (const Plane& plane : hull.planes) {
    const Real closing = glm::dot(plane.normal, direction);
    const Real above = glm::dot(plane.normal, origin) - plane.offset;
    if (closing == 0 && above > 0) return std::nullopt;
    if (closing < 0 && -above / closing > in.t) in = {-above / closing, plane.normal};
    if (closing > 0) out = std::min(out, -above / closing);
  }
  if (in.t > out) return std::nullopt;
  return in;
}

}  // namespace timestep
