#include "common/physics/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_epsilon = std::numeric_limits<Real>::epsilon();

// Differences of very large numbers may be too large for Real
Separation if_in_range(const Separation& s) {
  return std::isfinite(s.distance + s.error)
             ? s
             : Separation{.reason = Reason::out_of_range};
}

// A ball about a point of A's core and one about a point of B's, from A's position. The
// spare normal is for points that coincide, up to what rounding may have moved them
struct Balls {
  Vec3 on_a, on_b;
  Real radius_a, radius_b;
  Vec3 spare_normal;
  Real size;  // of the numbers that the points were computed from
};

Separation balls(const Balls& pair, const Vec3& origin) {
  const Vec3 gap = pair.on_b - pair.on_a;
  const Real distance = length_of(gap), rounding = 8 * k_epsilon * pair.size;
  const Real radii = pair.radius_a + pair.radius_b;
  Separation s;
  s.distance = distance - radii;
  s.normal = distance > rounding ? unit_or_zero(gap) : pair.spare_normal;
  s.on_a = origin + (pair.on_a + pair.radius_a * s.normal);
  s.on_b = origin + (pair.on_b - pair.radius_b * s.normal);
  s.error = rounding + 8 * k_epsilon * (distance + radii);
  return if_in_range(s);
}

// A capsule's core, its middle from A's position
struct Segment {
  Vec3 middle, axis;
  Real half;
};

Segment core_of(const Capsule& capsule, const Pose& pose, const Vec3& origin) {
  return {pose.position - origin, direction_in_world(pose, {0, 0, 1}),
          capsule.height / 2};
}

Vec3 closest_on(const Segment& s, const Vec3& point) {
  return s.middle
         + std::clamp(glm::dot(point - s.middle, s.axis), -s.half, s.half) * s.axis;
}

// Two points, and the common perpendicular of the lines that they are on if it tells
// their direction better than they do
struct ClosestPoints {
  Vec3 on_a, on_b;
  Vec3 across{0};
};

// An end of one segment and the point of the other that is closest to it
ClosestPoints closest_with_an_end(const Segment& a, const Segment& b) {
  ClosestPoints best{a.middle + a.half * a.axis, b.middle + b.half * b.axis};
  const auto offer = [&](const Vec3& p, const Vec3& q) {
    if (length_of(q - p) < length_of(best.on_b - best.on_a)) best = {p, q};
  };
  for (const Real side : {Real(-1), Real(1)}) {
    const Vec3 end_a = a.middle + side * a.half * a.axis;
    const Vec3 end_b = b.middle + side * b.half * b.axis;
    offer(end_a, closest_on(b, end_a));
    offer(closest_on(a, end_b), end_b);
  }
  return best;
}

// Of two segments: where their lines are closest, if that is within both. By cross
// products, which keep what dot products of nearly parallel axes lose
ClosestPoints closest(const Segment& a, const Segment& b) {
  const ClosestPoints with_an_end = closest_with_an_end(a, b);
  const Vec3 n = glm::cross(a.axis, b.axis), r = b.middle - a.middle;
  const Real n2 = glm::dot(n, n);
  if (!(n2 > 0)) return with_an_end;
  const Real s = glm::dot(glm::cross(r, b.axis), n) / n2;
  const Real t = glm::dot(glm::cross(r, a.axis), n) / n2;
  if (!(std::abs(s) <= a.half && std::abs(t) <= b.half)) return with_an_end;

  ClosestPoints crossing{a.middle + s * a.axis, b.middle + t * b.axis};
  const Real distance = length_of(crossing.on_b - crossing.on_a);
  if (distance > length_of(with_an_end.on_b - with_an_end.on_a)) return with_an_end;
  if (distance < (a.half + b.half) * std::sqrt(n2))
    crossing.across = unit_or_zero(glm::dot(n, r) < 0 ? -n : n);
  return crossing;
}

// From the sphere A's centre inside a solid B, or outside of it: the way to the solid's
// surface, in B's frame
Separation from_centre(const Sphere& a, const Pose& pose_a, const Pose& pose_b,
                       const Vec3& centre, const Vec3& surface, const Vec3& outward,
                       Real core_distance, Real size) {
  Separation s;
  s.distance = core_distance - a.radius;
  s.normal = direction_in_world(pose_b, -outward);
  s.on_a = pose_a.position + a.radius * s.normal;
  s.on_b = pose_a.position + direction_in_world(pose_b, surface - centre);
  s.error = 8 * k_epsilon * (size + length_of(centre) + a.radius);
  return if_in_range(s);
}

// The pair in the order in which its function takes it
std::optional<Separation> in_order(const Shape& a, const Pose& pose_a, const Shape& b,
                                   const Pose& pose_b) {
  if (const auto* plane = std::get_if<HalfSpace>(&b))
    return any_half_space(a, pose_a, *plane, pose_b);
  if (const auto* sphere = std::get_if<Sphere>(&a)) {
    if (const auto* other = std::get_if<Sphere>(&b))
      return sphere_sphere(*sphere, pose_a, *other, pose_b);
    if (const auto* box = std::get_if<Box>(&b))
      return sphere_box(*sphere, pose_a, *box, pose_b);
    if (const auto* capsule = std::get_if<Capsule>(&b))
      return sphere_capsule(*sphere, pose_a, *capsule, pose_b);
    if (const auto* cylinder = std::get_if<Cylinder>(&b))
      return sphere_cylinder(*sphere, pose_a, *cylinder, pose_b);
  }
  const auto* capsule = std::get_if<Capsule>(&a);
  const auto* other = std::get_if<Capsule>(&b);
  if (capsule != nullptr && other != nullptr)
    return capsule_capsule(*capsule, pose_a, *other, pose_b);
  return {};
}

}  // namespace

Separation sphere_sphere(const Sphere& a, const Pose& pose_a, const Sphere& b,
                         const Pose& pose_b) {
  return balls({.on_a = Vec3(0),
                .on_b = pose_b.position - pose_a.position,
                .radius_a = a.radius,
                .radius_b = b.radius,
                .spare_normal = {0, 0, 1},
                .size = 0},
               pose_a.position);
}

Separation sphere_box(const Sphere& a, const Pose& pose_a, const Box& b,
                      const Pose& pose_b) {
  const Vec3& h = b.half_extents;
  const Vec3 centre = point_in_body(pose_b, pose_a.position);
  const Vec3 surface = glm::clamp(centre, -h, h);
  const Vec3 out = centre - surface;
  if (out != Vec3(0))
    return from_centre(a, pose_a, pose_b, centre, surface, unit_or_zero(out),
                       length_of(out), length_of(h));

  // Inside: straight to the nearest face
  const Vec3 depths = h - glm::abs(centre);
  int axis = depths.y < depths.x ? 1 : 0;
  if (depths.z < depths[axis]) axis = 2;
  Vec3 outward(0), face = centre;
  outward[axis] = centre[axis] < 0 ? Real(-1) : Real(1);
  face[axis] = outward[axis] * h[axis];
  return from_centre(a, pose_a, pose_b, centre, face, outward, -depths[axis],
                     length_of(h));
}

Separation sphere_capsule(const Sphere& a, const Pose& pose_a, const Capsule& b,
                          const Pose& pose_b) {
  const Segment core = core_of(b, pose_b, pose_a.position);
  return balls({.on_a = Vec3(0),
                .on_b = closest_on(core, Vec3(0)),
                .radius_a = a.radius,
                .radius_b = b.radius,
                .spare_normal = any_perpendicular(core.axis),
                .size = core.half + length_of(core.middle)},
               pose_a.position);
}

Separation capsule_capsule(const Capsule& a, const Pose& pose_a, const Capsule& b,
                           const Pose& pose_b) {
  const Segment core_a = core_of(a, pose_a, pose_a.position);
  const Segment core_b = core_of(b, pose_b, pose_a.position);
  const auto [on_a, on_b, across] = closest(core_a, core_b);
  Balls pair{.on_a = on_a,
             .on_b = on_b,
             .radius_a = a.radius,
             .radius_b = b.radius,
             .spare_normal = any_perpendicular(core_a.axis),
             .size = core_a.half + core_b.half + length_of(core_b.middle)};
  if (across == Vec3(0)) return balls(pair, pose_a.position);
  pair.spare_normal = across;
  pair.on_b = on_a + glm::dot(across, on_b - on_a) * across;
  return balls(pair, pose_a.position);
}

Separation sphere_cylinder(const Sphere& a, const Pose& pose_a, const Cylinder& b,
                           const Pose& pose_b) {
  const Vec3 centre = point_in_body(pose_b, pose_a.position);
  const Real half = b.height / 2, across = std::hypot(centre.x, centre.y);
  const Vec3 radial =
      across > 0 ? Vec3(centre.x / across, centre.y / across, 0) : Vec3(1, 0, 0);
  const Vec3 axial(0, 0, centre.z < 0 ? -1 : 1);
  const Real beyond_side = across - b.radius;
  const Real beyond_face = std::abs(centre.z) - half;
  const Real size = std::hypot(b.radius, half);

  // Inside: through the side or a flat face
  if (beyond_side <= 0 && beyond_face <= 0) {
    const bool side = beyond_side >= beyond_face;
    const Real depth = side ? beyond_side : beyond_face;
    const Vec3 outward = side ? radial : axial;
    return from_centre(a, pose_a, pose_b, centre, centre - depth * outward, outward,
                       depth, size);
  }
  const Vec3 out =
      std::max(beyond_side, Real(0)) * radial + std::max(beyond_face, Real(0)) * axial;
  return from_centre(a, pose_a, pose_b, centre, centre - out, unit_or_zero(out),
                     length_of(out), size);
}

Separation any_half_space(const Shape& a, const Pose& pose_a, const HalfSpace& b,
                          const Pose& pose_b) {
  Separation s;
  const Vec3 up = direction_in_world(pose_b, b.normal);
  s.normal = -up;
  if (std::holds_alternative<HalfSpace>(a)) {
    s.distance = -std::numeric_limits<Real>::infinity();
    s.reason = Reason::unbounded;
    return s;
  }

  // The lowest point of A, above the plane through B's frame
  const Convex body = convex(a);
  std::uint32_t hint = 0;
  const Vec3 lowest =
      body.core_support(body.shape, direction_in_body(pose_a, s.normal), hint);
  const Vec3 from_a = direction_in_world(pose_a, lowest);
  const Vec3 between = pose_a.position - pose_b.position;
  s.distance = glm::dot(up, between + from_a) - b.offset - body.radius;
  s.on_a = pose_a.position + (from_a - body.radius * up);
  s.on_b = s.on_a - s.distance * up;
  s.error = 8 * k_epsilon
            * (length_of(between) + body.reach + body.radius + std::abs(b.offset));
  return if_in_range(s);
}

std::optional<Separation> closed_form(const Shape& a, const Pose& pose_a,
                                      const Shape& b, const Pose& pose_b) {
  if (const auto found = in_order(a, pose_a, b, pose_b)) return found;
  const auto found = in_order(b, pose_b, a, pose_a);
  return found ? std::optional(swapped(*found)) : std::nullopt;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
