#include "common/physics/gjk.hpp"

#include <algorithm>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// Where v is at the origin, rounding has the last word on its direction
Vec3 direction_to(const Vec3& v, Real distance) {
  return distance > 0 ? v / distance : Vec3(1, 0, 0);
}

bool holds(const Simplex& simplex, const Vec3& w) {
  for (int i = 0; i < simplex.size; ++i)
    if (simplex.vertices[std::size_t(i)].w == w) return true;
  return false;
}

bool has_all_four(const ClosestPoint& closest) {
  return std::ranges::all_of(closest.weights, [](Real w) { return w > 0; });
}

void finish(Gjk& gjk, Reason reason) {
  gjk.reason = reason;
  gjk.done = true;
}

}  // namespace

Gjk gjk_start(const MinkowskiDifference& difference, const GjkCache* cache) {
  Gjk gjk;
  if (cache != nullptr && cache->simplex.size > 0) {
    gjk.simplex = cache->simplex;
    for (int i = 0; i < gjk.simplex.size; ++i) {
      SupportPoint& p = gjk.simplex.vertices[std::size_t(i)];
      p.w = difference_at(difference, p.a, p.b);
    }
  } else {
    const Vec3& t = difference.offset;
    gjk.simplex.size = 1;
    gjk.simplex.vertices[0] = support(difference, direction_to(t, glm::length(t)));
    gjk.iterations = 1;
  }
  gjk.v = reduce_to_closest(gjk.simplex);
  gjk.done = cores_meet(gjk);
  return gjk;
}

void gjk_step(const MinkowskiDifference& difference, Gjk& gjk) {
  // No point of the difference is nearer than the plane through the support point
  const Real upper = glm::length(gjk.v);
  const Vec3 normal = direction_to(gjk.v, upper);
  Simplex& simplex = gjk.simplex;
  const auto size = std::size_t(simplex.size);
  SupportPoint& next = simplex.vertices[size];
  find_support(difference, normal, simplex.vertices[size - 1], next);
  ++gjk.iterations;
  const Real lower = glm::dot(normal, next.w);
  const bool rises = lower > gjk.lower, is_along_v = lower > gjk.lower - k_rounding;
  if (is_along_v) gjk.normal = normal;
  gjk.lower = std::max(gjk.lower, lower);

  // (4.16) The duality gap; times |v| it is the v.v - v.w of the textbooks. Rounding
  // may keep it open, but then neither bound moves any more
  const Real gap = upper - gjk.lower;
  const Reason at_rest = gap <= k_rounding ? Reason::converged : Reason::no_progress;
  const bool is_tight = gap <= k_rounding / 16 && is_along_v;
  if (is_tight || holds(simplex, next.w)) return finish(gjk, at_rest);

  // The larger simplex's closest point, if that is closer
  ++simplex.size;
  ClosestPoint closest = closest_to_origin(simplex);
  if (has_all_four(closest) && gjk.lower > k_rounding)
    closest = closest_on_face(simplex);
  const Real closer = glm::length(closest.point);
  if (!(closer < upper || (rises && closer <= upper + k_rounding / 16))) {
    --simplex.size;
    return finish(gjk, at_rest);
  }
  keep(simplex, closest);
  gjk.v = closest.point;
  if (cores_meet(gjk)) return finish(gjk, Reason::converged);
  if (gjk.iterations >= k_gjk_limit) finish(gjk, Reason::iteration_limit);
}

Gjk run_gjk(const MinkowskiDifference& difference, GjkCache* cache) {
  Gjk gjk = gjk_start(difference, cache);
  while (!gjk.done) gjk_step(difference, gjk);
  if (cache != nullptr) cache->simplex = gjk.simplex;
  return gjk;
}

bool cores_meet(const Gjk& gjk) {
  return gjk.simplex.size == 4 || !(glm::length(gjk.v) > k_rounding);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
