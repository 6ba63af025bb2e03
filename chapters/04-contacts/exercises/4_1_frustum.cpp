// Below, the frustum is taken for the cylinder around it, and the direction for one
// whose part across the axis is never zero. Mend both.
//
// Hints: on either disc, the farthest point is on the rim, where the part of the
// direction across the axis points. The farthest point of the frustum is one of these
// two: the frustum is their convex hull. Which one, a dot product tells.
//
// `std::hypot` gives the length of the part across the axis without squares that
// vanish. Straight up, it is zero; what then is a point of the disc?
#include "chapters/04-contacts/exercises/4_1_frustum.hpp"

#include <algorithm>
#include <cmath>

namespace timestep {

Vec3 support(const Frustum& frustum, const Vec3& direction) {
  const Real radius = std::max(frustum.lower, frustum.upper);
  const Real across = std::hypot(direction.x, direction.y);
  return {radius * direction.x / across, radius * direction.y / across,
          direction.z > 0 ? frustum.height : 0};
}

}  // namespace timestep
