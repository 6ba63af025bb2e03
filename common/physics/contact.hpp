/// @file
/// Which bodies touch, or are about to, and where: the list that everything later works
/// on. Source: chapter 5.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "common/physics/manifold.hpp"
#include "common/physics/rigid_body.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A shape on a body, and what its surface is like. A body may have several.
struct Collider {
  std::uint32_t body = 0;  ///< its index
  Shape shape = Sphere{1};
  Pose pose{};                ///< body from shape
  Real friction = Real(0.5);  ///< of what slips over it
  Real static_friction = 0;   ///< of what does not slip yet, where it is more
  Real rolling_friction = 0;  ///< [m] torque against rolling, over the normal force
  Real restitution = 0;       ///< parting speed over closing speed, 0 to 1
  std::uint32_t id = 0;       ///< ascending from collider to collider
};

/// A point where two bodies touch, or may within the step.
struct PointContact {
  std::uint32_t a, b;                    ///< bodies
  std::uint32_t collider_a, collider_b;  ///< ids; collider_a < collider_b
  std::uint64_t feature;                 ///< of the pair: see ContactPoint
  Vec3 position;                         ///< [m] world, halfway between the surfaces
  Vec3 normal;                           ///< unit, from A to B
  Real depth;                            ///< [m] negative across a gap
  Real friction, restitution;
  Real static_friction = 0, rolling_friction = 0;  ///< see Collider
  Vec3 across{0};   ///< [m] from A's point to B's, if they are apart and will meet
  Vec3 impulse{0};  ///< [N s] on B, in the last step or substep: the warm start
};

/// A body's pose, and a collider's in the world.
inline Pose pose_of(const RigidBody& body) {
  return {body.position, body.orientation};
}
inline Pose world_pose(const RigidBody& body, const Collider& collider) {
  return {world_point(body, collider.pose.position),
          body.orientation * collider.pose.orientation};
}

/// Where two shapes touch. Those further apart than `margin` [m] do not. By the
/// separating axis test of boxes, closed forms, or GJK and EPA, whichever is the first
/// to have an answer.
Manifold touch(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
               Real margin);

/// What a pair of surfaces has in common: the geometric mean of the frictions, of those
/// that hold and of those that slip; the larger restitution and rolling friction.
inline Real mixed_friction(const Collider& a, const Collider& b) {
  return std::sqrt(a.friction * b.friction);
}
inline Real mixed_static_friction(const Collider& a, const Collider& b) {
  if (a.static_friction == 0 && b.static_friction == 0) return 0;
  const Real of_a = a.static_friction > a.friction ? a.static_friction : a.friction;
  const Real of_b = b.static_friction > b.friction ? b.static_friction : b.friction;
  return std::sqrt(of_a * of_b);
}
inline Real mixed_rolling_friction(const Collider& a, const Collider& b) {
  return a.rolling_friction > b.rolling_friction ? a.rolling_friction
                                                 : b.rolling_friction;
}
inline Real mixed_restitution(const Collider& a, const Collider& b) {
  return a.restitution > b.restitution ? a.restitution : b.restitution;
}

/// Two colliders, by their places in the list.
struct ColliderPair {
  std::uint32_t a, b;
};

/// What the search keeps between two steps, so that it allocates nothing.
struct ContactSearch {
  std::vector<Pose> poses;           ///< of the colliders, world
  std::vector<Real> reaches;         ///< [m] how far their surfaces may get in the step
  std::vector<Bounds> boxes;         ///< around all places that they may get to
  std::vector<std::uint32_t> order;  ///< of the boxes, by their lower ends
  std::vector<Bounds> sorted;        ///< the boxes in that order
  std::vector<ColliderPair> pairs;   ///< whose boxes overlap, a < b, ascending
};

/// All pairs of colliders of different bodies, not both static, whose boxes overlap, by
/// sorting the boxes along an axis and sweeping over them. Their order depends on
/// nothing but the list of colliders.
void find_pairs(std::span<const RigidBody> bodies, std::span<const Collider> colliders,
                ContactSearch& search);

/// All contact points of all pairs that are no further apart than `margin` [m], or will
/// be within dt [s] as they move now, under an acceleration of up to `acceleration`
/// [m/s²]. Those of the latter are as they will be when the pair meets. `contacts` is
/// overwritten.
void find_contacts(std::span<const RigidBody> bodies,
                   std::span<const Collider> colliders, Real margin, Real acceleration,
                   Real dt, ContactSearch& search, std::vector<PointContact>& contacts);

/// Contacts that slip more slowly than `speed` [m/s] have static friction, where that
/// is more.
void hold_still(std::span<const RigidBody> bodies, Real speed,
                std::span<PointContact> contacts);

/// Gives each contact the impulse that the same one had before: of the same colliders,
/// the same feature. One whose feature is new, as where corners lie on each other and
/// change places, has that of the nearest that is left, no further than `reach` [m].
/// Both lists are in the order of the pairs.
void carry_impulses(std::span<const PointContact> before, Real reach,
                    std::span<PointContact> contacts);

}  // namespace timestep::inline TIMESTEP_PRECISION
