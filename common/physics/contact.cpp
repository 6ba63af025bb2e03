#include "common/physics/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "common/physics/pair_query.hpp"
#include "common/physics/primitives.hpp"
#include "common/physics/sat.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

bool is_static(const RigidBody& body) {
  return body.inverse_mass == 0;
}

// How fast any point of a collider is at most, beside the body's velocity
Real spin_speed(const RigidBody& body, const Collider& collider) {
  if (std::holds_alternative<HalfSpace>(collider.shape)) return 0;
  const Convex shape = convex(collider.shape);
  const Real arm = glm::length(collider.pose.position) + shape.reach + shape.radius;
  return arm * glm::length(body.angular_velocity);
}

// How far any point of a collider moves in dt at the body's velocity, or falls
Real travel(const RigidBody& body, const Collider& collider, Real acceleration,
            Real dt) {
  const Real speed = glm::length(body.velocity) + spin_speed(body, collider);
  return dt * (speed + (is_static(body) ? 0 : dt / 2 * acceleration));
}

// Of a box and a ball without asking their support functions six times
Bounds fast_bounds(const Shape& shape, const Pose& pose) {
  Vec3 half;
  if (const auto* box = std::get_if<Box>(&shape)) {
    const Mat3 R = matrix_of(pose.orientation);
    for (glm::length_t i = 0; i < 3; ++i)
      half[i] = std::abs(R[0][i]) * box->half_extents.x
                + std::abs(R[1][i]) * box->half_extents.y
                + std::abs(R[2][i]) * box->half_extents.z;
  } else if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    half = Vec3(sphere->radius);
  } else {
    return bounds(shape, pose);
  }
  return {pose.position - half, pose.position + half};
}

void place(std::span<const RigidBody> bodies, std::span<const Collider> colliders,
           Real margin, Real acceleration, Real dt, ContactSearch& search) {
  search.poses.clear();
  search.reaches.clear();
  search.boxes.clear();
  for (const Collider& collider : colliders) {
    const RigidBody& body = bodies[collider.body];
    const Pose pose = world_pose(body, collider);
    const Real reach = travel(body, collider, acceleration, dt);
    Bounds box = fast_bounds(collider.shape, pose);
    box.low -= margin / 2 + reach;
    box.high += margin / 2 + reach;
    search.poses.push_back(pose);
    search.reaches.push_back(reach);
    search.boxes.push_back(box);
  }
}

// Along one axis. Without a branch: which of many comparisons fails is hard to predict
bool overlap(const Bounds& a, const Bounds& b, glm::length_t axis) {
  return bool(int(a.low[axis] <= b.high[axis]) & int(b.low[axis] <= a.high[axis]));
}

// The axis along which the boxes' middles are spread most, so that fewest overlap
glm::length_t widest_axis(std::span<const Bounds> boxes) {
  Vec3 sum(0), squares(0);
  Real count = 0;
  for (const Bounds& box : boxes) {
    const Vec3 middle = (box.low + box.high) / Real(2);
    if (!std::isfinite(middle.x)) continue;
    sum += middle;
    squares += middle * middle;
    ++count;
  }
  const Vec3 spread = squares - sum * sum / std::max(count, Real(1));
  glm::length_t axis = 0;
  for (const glm::length_t i : {1, 2})
    if (spread[i] > spread[axis]) axis = i;
  return axis;
}

// As many as before, in the order of before, which is nearly right
void keep_order(std::size_t count, std::vector<std::uint32_t>& order) {
  if (order.size() != count) {
    order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  }
}

Manifold touch_by_distance(const Shape& a, const Pose& pose_a, const Shape& b,
                           const Pose& pose_b, Real margin) {
  const auto closed = closed_form(a, pose_a, b, pose_b);
  const Separation s = closed ? *closed : separation(a, pose_a, b, pose_b);
  if (s.reason == Reason::out_of_range || s.reason == Reason::unbounded) return {};
  return contact_manifold(a, pose_a, b, pose_b, s, margin);
}

// By the axes, unless they cannot tell: a lower bound of a distance is one only where
// faces are on each other
Manifold touch_boxes(const Shape& a, const Pose& pose_a, const Shape& b,
                     const Pose& pose_b, Real margin) {
  const Box &box_a = std::get<Box>(a), &box_b = std::get<Box>(b);
  const SatResult found = sat(box_a, pose_a, box_b, pose_b);
  const Separation& s = found.separation;
  Manifold manifold = s.distance > margin
                          ? Manifold{}
                          : contact_manifold(box_a, pose_a, box_b, pose_b, s, margin);
  if (s.distance > 0 && s.distance <= margin && manifold.count < 3)
    manifold = touch_by_distance(a, pose_a, b, pose_b, margin);
  return manifold;
}

Real deepest(const Manifold& manifold) {
  Real most = manifold.points[0].depth;
  for (int i = 1; i < manifold.count; ++i)
    most = std::max(most, manifold.points[std::size_t(i)].depth);
  return most;
}

// A collider on its body, and where it is
struct Mover {
  const Collider& collider;
  const RigidBody& body;
  const Pose& pose;
};

Pose pose_after(const Mover& mover, Real time) {
  if (time == 0) return mover.pose;
  RigidBody body = mover.body;
  body.position += time * body.velocity;
  body.orientation =
      glm::normalize(rotation_by(time * body.angular_velocity) * body.orientation);
  return world_pose(body, mover.collider);
}

// [m/s] How fast a gap along n from A to B can close, whichever of their points it is
// between
Real closing_speed(const Mover& a, const Mover& b, const Vec3& n) {
  return spin_speed(a.body, a.collider) + spin_speed(b.body, b.collider)
         - glm::dot(b.body.velocity - a.body.velocity, n);
}

// A plane between two boxes, which is quickly found; of other shapes none, at no
// distance
Separation plane_between(const Shape& a, const Pose& pose_a, const Shape& b,
                         const Pose& pose_b) {
  const auto* const box_a = std::get_if<Box>(&a);
  const auto* const box_b = std::get_if<Box>(&b);
  if (box_a == nullptr || box_b == nullptr) return {};
  return sat(*box_a, pose_a, *box_b, pose_b).separation;
}

// When a pair that is apart will be within a hundredth of the margin, at most dt: on
// and on by the time that it takes at least, whichever of their points is nearest
Real meeting_time(const Mover& a, const Mover& b, Real margin, Real dt) {
  constexpr int k_most_steps = 16;
  Real time = 0;
  for (int i = 0; i < k_most_steps; ++i) {
    const Pose pose_a = pose_after(a, time), pose_b = pose_after(b, time);
    Separation s = plane_between(a.collider.shape, pose_a, b.collider.shape, pose_b);
    if (s.distance <= margin / 100)
      s = separation(a.collider.shape, pose_a, b.collider.shape, pose_b);
    if (s.distance <= margin / 100) return time;
    const Real closing = closing_speed(a, b, s.normal);
    if (closing * (dt - time) <= s.distance) return dt;
    time += s.distance / closing;
  }
  return time;
}

// A point of a manifold, which may be that of a time within the step: the arms are as
// they will be, the gap is what closes until then
void set_contact(const Mover& a, const Mover& b, const Manifold& manifold,
                 const ContactPoint& point, Real time, PointContact& contact) {
  const Vec3 moved_a = time * a.body.velocity, moved_b = time * b.body.velocity;
  const Vec3 start_a = on_a(manifold, point) - moved_a;
  const Vec3 start_b = on_b(manifold, point) - moved_b;
  const Vec3 turned =
      time
      * (glm::cross(b.body.angular_velocity, start_b - b.body.position)
         - glm::cross(a.body.angular_velocity, start_a - a.body.position));
  const Real closed = glm::dot(manifold.normal, moved_b - moved_a + turned);
  contact.a = a.collider.body;
  contact.b = b.collider.body;
  contact.collider_a = a.collider.id;
  contact.collider_b = b.collider.id;
  contact.feature = point.feature;
  contact.position = (start_a + start_b) / Real(2);
  contact.normal = manifold.normal;
  contact.depth = point.depth + closed;
  contact.friction = mixed_friction(a.collider, b.collider);
  contact.static_friction = mixed_static_friction(a.collider, b.collider);
  contact.rolling_friction = mixed_rolling_friction(a.collider, b.collider);
  contact.restitution = mixed_restitution(a.collider, b.collider);
  contact.across = contact.depth < 0 ? start_b - start_a : Vec3(0);
}

std::uint64_t pair_of(const PointContact& contact) {
  return std::uint64_t(contact.collider_a) << 32 | contact.collider_b;
}

// By feature; then what is left, to the nearest that is left
void carry_impulses_of_pair(std::span<const PointContact> before, Real reach,
                            std::span<PointContact> contacts) {
  std::uint32_t given = 0, taken = 0;  // bit by bit, of a pair's points
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    for (std::uint32_t k = 0; k < before.size(); ++k) {
      if (before[k].feature != contacts[i].feature) continue;
      contacts[i].impulse = before[k].impulse;
      given |= 1U << i;
      taken |= 1U << k;
      break;
    }
  }
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    if ((given >> i & 1U) != 0) continue;
    Real nearest = reach * reach;
    std::uint32_t best = 32;
    for (std::uint32_t k = 0; k < before.size(); ++k) {
      if ((taken >> k & 1U) != 0) continue;
      const Vec3 way = before[k].position - contacts[i].position;
      const Real squared = glm::dot(way, way);
      if (squared > nearest) continue;
      nearest = squared;
      best = k;
    }
    if (best == 32) continue;
    contacts[i].impulse = before[best].impulse;
    taken |= 1U << best;
  }
}

}  // namespace

Manifold touch(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
               Real margin) {
  if (std::holds_alternative<Box>(a) && std::holds_alternative<Box>(b))
    return touch_boxes(a, pose_a, b, pose_b, margin);
  return touch_by_distance(a, pose_a, b, pose_b, margin);
}

void find_pairs(std::span<const RigidBody> bodies, std::span<const Collider> colliders,
                ContactSearch& search) {
  const std::vector<Bounds>& boxes = search.boxes;
  const glm::length_t axis = widest_axis(boxes), next = (axis + 1) % 3,
                      last = (axis + 2) % 3;
  keep_order(boxes.size(), search.order);
  std::ranges::sort(search.order, {},
                    [&](std::uint32_t i) { return std::tuple(boxes[i].low[axis], i); });

  search.sorted.clear();
  for (const std::uint32_t i : search.order) search.sorted.push_back(boxes[i]);

  search.pairs.clear();
  for (std::size_t i = 0; i < search.order.size(); ++i) {
    const std::uint32_t first = search.order[i];
    const Bounds& box = search.sorted[i];
    const bool first_is_static = is_static(bodies[colliders[first].body]);
    for (std::size_t k = i + 1; k < search.order.size(); ++k) {
      if (search.sorted[k].low[axis] > box.high[axis]) break;
      const Bounds& beside = search.sorted[k];
      if (!(int(overlap(box, beside, next)) & int(overlap(box, beside, last))))
        continue;
      const std::uint32_t other = search.order[k];
      const std::uint32_t body = colliders[other].body;
      if (body == colliders[first].body) continue;
      if (first_is_static && is_static(bodies[body])) continue;
      search.pairs.push_back({std::min(first, other), std::max(first, other)});
    }
  }
  std::ranges::sort(search.pairs, {}, [](const ColliderPair& pair) {
    return std::uint64_t(pair.a) << 32 | pair.b;
  });
}

void find_contacts(std::span<const RigidBody> bodies,
                   std::span<const Collider> colliders, Real margin, Real acceleration,
                   Real dt, ContactSearch& search,
                   std::vector<PointContact>& contacts) {
  place(bodies, colliders, margin, acceleration, dt, search);
  find_pairs(bodies, colliders, search);
  contacts.clear();
  for (const auto& [i, k] : search.pairs) {
    const Mover a{colliders[i], bodies[colliders[i].body], search.poses[i]};
    const Mover b{colliders[k], bodies[colliders[k].body], search.poses[k]};
    const Real reach = search.reaches[i] + search.reaches[k];

    // Most that are fast and near stay on their sides of a plane
    const Separation plane = reach > margin ? plane_between(a.collider.shape, a.pose,
                                                            b.collider.shape, b.pose)
                                            : Separation{};
    const bool is_apart = plane.distance > margin;
    const Real room = plane.distance - margin;
    if (is_apart && closing_speed(a, b, plane.normal) * dt <= room) continue;

    // Others are looked at where they are now, or where they will meet
    Manifold manifold;
    if (!is_apart)
      manifold =
          touch(a.collider.shape, a.pose, b.collider.shape, b.pose, margin + reach);
    Real time = 0;
    if (is_apart || (manifold.count > 0 && deepest(manifold) < -margin)) {
      time = meeting_time(a, b, margin, dt);
      manifold = touch(a.collider.shape, pose_after(a, time), b.collider.shape,
                       pose_after(b, time), margin);
    }
    for (int p = 0; p < manifold.count; ++p)
      set_contact(a, b, manifold, manifold.points[std::size_t(p)], time,
                  contacts.emplace_back());
  }
}

void hold_still(std::span<const RigidBody> bodies, Real speed,
                std::span<PointContact> contacts) {
  for (PointContact& c : contacts) {
    if (c.static_friction <= c.friction) continue;
    const Vec3 v =
        velocity_at(bodies[c.b], c.position) - velocity_at(bodies[c.a], c.position);
    const Vec3 slip = v - glm::dot(v, c.normal) * c.normal;
    if (glm::dot(slip, slip) < speed * speed) c.friction = c.static_friction;
  }
}

void carry_impulses(std::span<const PointContact> before, Real reach,
                    std::span<PointContact> contacts) {
  std::size_t start = 0;
  for (std::size_t first = 0, end = 0; first < contacts.size(); first = end) {
    const std::uint64_t pair = pair_of(contacts[first]);
    while (end < contacts.size() && pair_of(contacts[end]) == pair) ++end;
    while (start < before.size() && pair_of(before[start]) < pair) ++start;
    std::size_t stop = start;
    while (stop < before.size() && pair_of(before[stop]) == pair) ++stop;
    carry_impulses_of_pair(before.subspan(start, stop - start), reach,
                           contacts.subspan(first, end - first));
    start = stop;
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
