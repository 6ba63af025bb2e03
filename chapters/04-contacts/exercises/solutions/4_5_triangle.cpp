// The weights of the corners are the areas of three triangles, with p in place of one
// corner each, as seen along the normal. They are cross products: no squares of areas.
// If none is negative, p is above the face, and weights that add up to 1 put the point
// into the triangle whatever rounding did to them. Then it is one of four candidates.
// If the triangle is so thin that its normal is rounding's, the face's candidate is
// some point of the triangle, no more; but then every point of it is within rounding of
// an edge, and the edges' candidates are right.
#include "chapters/04-contacts/exercises/4_5_triangle.hpp"

#include <algorithm>

namespace timestep {

namespace {

Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  const Real ee = glm::dot(e, e);
  if (!(ee > 0)) return a;
  return a + std::clamp(glm::dot(e, p - a) / ee, Real(0), Real(1)) * e;
}

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 closest = closest_on_segment(p, a, b);
  const auto offer = [&](const Vec3& point) {
    if (glm::distance(p, point) < glm::distance(p, closest)) closest = point;
  };
  offer(closest_on_segment(p, b, c));
  offer(closest_on_segment(p, c, a));

  // (4.13) Above the face: the areas opposite to each corner
  const Vec3 n = glm::cross(b - a, c - a);
  const Real at_a = glm::dot(n, glm::cross(b - p, c - p));
  const Real at_b = glm::dot(n, glm::cross(c - p, a - p));
  const Real at_c = glm::dot(n, glm::cross(a - p, b - p));
  const Real all = at_a + at_b + at_c;
  if (at_a >= 0 && at_b >= 0 && at_c >= 0 && all > 0)
    offer(a + at_b / all * (b - a) + at_c / all * (c - a));
  return closest;
}

}  // namespace timestep
