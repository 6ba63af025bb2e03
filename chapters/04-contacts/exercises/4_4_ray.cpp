// Below, the ray hits wherever it crosses the plane of a face, even beside the hull.
// Mend that.
//
// Hints: a hull is what is behind all its planes: dot(normal, x) <= offset. Along the
// ray each plane is crossed once, at a t that is easy to find. A ray that goes against
// the normal comes in there, one that goes along it goes out. It is in the hull after
// it has come in through the last plane, and before it has gone out through the first.
//
// A ray parallel to a plane is in front of it all the way, or behind.
#include "chapters/04-contacts/exercises/4_4_ray.hpp"

namespace timestep {

std::optional<RayHit> cast_ray(const ConvexHull& hull, const Vec3& origin,
                               const Vec3& direction) {
  for (const Plane& plane : hull.planes) {
    const Real closing = glm::dot(plane.normal, direction);
    const Real above = glm::dot(plane.normal, origin) - plane.offset;
    if (closing < 0 && above > 0) return RayHit{-above / closing, plane.normal};
  }
  return std::nullopt;
}

}  // namespace timestep
