// A linear function is greatest on one of the discs, since every point of the frustum
// is between a point of the one and a point of the other. On a disc it is greatest
// where the rim is farthest in the direction's part across the axis. That part's length
// may be zero, and then the whole disc ties: its middle serves.
#include "chapters/04-contacts/exercises/4_1_frustum.hpp"

#include <cmath>

namespace timestep {

Vec3 support(const Frustum& frustum, const Vec3& direction) {
  const Real across = std::hypot(direction.x, direction.y);
  const Vec3 outwards =
      across > 0 ? Vec3(direction.x / across, direction.y / across, 0) : Vec3(0);
  const Vec3 low = frustum.lower * outwards;
  const Vec3 high = frustum.upper * outwards + Vec3(0, 0, frustum.height);
  return glm::dot(direction, high) > glm::dot(direction, low) ? high : low;
}

}  // namespace timestep
