#include "common/physics/libccd_query.hpp"

#include <cmath>
#include <limits>

#include <ccd/ccd.h>

#include "common/physics/minkowski.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// Of a pair's size
constexpr ccd_real_t k_tolerance = CCD_REAL(1e-8);

// Polyhedra take some dozens; without a limit EPA does not end on every pair
constexpr int k_most_supports = 500;

// A shape as libccd sees it: lengths in units, A's frame without its turn
struct Body {
  Convex convex;
  Pose pose;    // [m]
  Vec3 centre;  // of the shape's frame [m], inside the shape
  Real scale;   // 1 / unit
  int* supports;
  bool is_first;
};

ccd_vec3_t to_ccd(const Vec3& v) {
  return {{ccd_real_t(v.x), ccd_real_t(v.y), ccd_real_t(v.z)}};
}

Vec3 from_ccd(const ccd_vec3_t& v) {
  return {v.v[0], v.v[1], v.v[2]};
}

// Past the limit the difference of the two points is against the direction that was
// asked for. Each loop of libccd's ends at that, as at a support point that gains
// nothing
void support_of(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const Vec3 d = from_ccd(*direction);
  if (body.is_first && ++*body.supports > k_most_supports) {
    *point = to_ccd(-d);
  } else if (*body.supports > k_most_supports) {
    *point = to_ccd(Vec3(0));
  } else {
    std::uint32_t hint = 0;
    const Convex& convex = body.convex;
    const Vec3 core =
        convex.core_support(convex.shape, direction_in_body(body.pose, d), hint);
    const Vec3 far = point_in_world(body.pose, core) + convex.radius * unit_or_zero(d);
    *point = to_ccd(body.scale * far);
  }
}

void centre_of(const void* object, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  *point = to_ccd(body.scale * point_in_world(body.pose, body.centre));
}

Vec3 inner_point(const Shape& shape) {
  if (const auto* cone = std::get_if<Cone>(&shape)) return {0, 0, cone->height / 4};
  const auto* hull = std::get_if<HullShape>(&shape);
  if (hull == nullptr) return Vec3(0);
  Vec3 mean(0);
  for (const Vec3& v : hull->vertices) mean += v / Real(hull->vertices.size());
  return mean;
}

using Algorithm = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*,
                          ccd_vec3_t*, ccd_vec3_t*);

Separation apart(const Pose& pose_a, const Pose& pose_b) {
  const Vec3 across = unit_or_zero(pose_b.position - pose_a.position);
  const Vec3 middle = (pose_a.position + pose_b.position) / Real(2);
  return {.distance = std::numeric_limits<Real>::min(),
          .normal = across == Vec3(0) ? Vec3(0, 0, 1) : across,
          .on_a = middle,
          .on_b = middle,
          .reason = Reason::lower_bound};
}

// What libccd says of shapes that meet: no direction where they only touch
Separation overlapping(const Pose& pose_a, const Pose& pose_b, Real depth,
                       const Vec3& direction, const Vec3& middle) {
  Separation s = apart(pose_a, pose_b);
  s.reason = Reason::converged;
  s.distance = -depth;
  if (direction != Vec3(0)) s.normal = unit_or_zero(direction);
  s.on_a = middle + depth / 2 * s.normal;
  s.on_b = middle - depth / 2 * s.normal;
  const Vec3 sum = s.on_a + s.on_b + direction;
  const bool is_number = std::isfinite(depth + sum.x + sum.y + sum.z);
  return is_number ? s : Separation{.reason = Reason::no_answer};
}

Separation query(Algorithm algorithm, const Shape& a, const Pose& pose_a,
                 const Shape& b, const Pose& pose_b) {
  if (!libccd_takes(a, b)) return {.reason = Reason::no_answer};
  const Convex convex_a = convex(a), convex_b = convex(b);
  const MinkowskiDifference difference =
      minkowski_difference(convex_a, pose_a, convex_b, pose_b);
  if (!(difference.unit > 0)) return {.reason = Reason::out_of_range};

  // Put the pair before libccd, from A's position
  const Real unit = difference.unit + convex_a.radius + convex_b.radius;
  int supports = 0;
  const Pose here{Vec3(0), pose_a.orientation};
  const Pose there{pose_b.position - pose_a.position, pose_b.orientation};
  const Body body_a{convex_a, here, inner_point(a), 1 / unit, &supports, true};
  const Body body_b{convex_b, there, inner_point(b), 1 / unit, &supports, false};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support_of;
  ccd.center1 = ccd.center2 = centre_of;
  ccd.max_iterations = k_most_supports;
  ccd.epa_tolerance = ccd.mpr_tolerance = k_tolerance;
  ccd_real_t depth = 0;
  ccd_vec3_t direction = to_ccd(Vec3(0)), position = direction;
  const int status = algorithm(&body_a, &body_b, &ccd, &depth, &direction, &position);

  // Its answer, in the world and in metres
  Separation s =
      status == -2 ? Separation{.reason = Reason::no_answer}
      : status == -1
          ? apart(pose_a, pose_b)
          : overlapping(pose_a, pose_b, unit * Real(depth), from_ccd(direction),
                        pose_a.position + unit * from_ccd(position));
  s.iterations = supports;
  if (supports > k_most_supports) s.reason = Reason::iteration_limit;
  if (status == 0) s.error = Real(k_tolerance) * unit;
  return s;
}

}  // namespace

Separation libccd_epa(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b) {
  return query(ccdGJKPenetration, a, pose_a, b, pose_b);
}

Separation libccd_mpr(const Shape& a, const Pose& pose_a, const Shape& b,
                      const Pose& pose_b) {
  return query(ccdMPRPenetration, a, pose_a, b, pose_b);
}

bool libccd_takes(const Shape& a, const Shape& b) {
  return !std::holds_alternative<HalfSpace>(a) && !std::holds_alternative<HalfSpace>(b);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
