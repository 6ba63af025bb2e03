/// @file
/// Exercise 4.4, core: A ray against a hull
#pragma once

#include <optional>

#include "common/physics/convex_hull.hpp"

namespace timestep {

/// Where a ray enters a shape.
struct RayHit {
  Real t;  ///< at origin + t direction
  Vec3
      normal;  ///< of the face there, of length one, outwards; zero if it starts inside
};

/// The first point of a ray, all origin + t direction with t >= 0, that is in a convex
/// hull [m]; nothing if none is. A ray that starts inside hits at t = 0. The direction
/// is not zero; its length does not matter but to t.
std::optional<RayHit> cast_ray(const ConvexHull& hull, const Vec3& origin,
                               const Vec3& direction);

}  // namespace timestep
