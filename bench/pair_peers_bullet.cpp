// Bullet about the pairs of truth files.
#include <memory>

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletCollisionCommon.h>

#include "bench/pair_peers.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using Shaped = std::unique_ptr<btConvexShape>;

btVector3 bullet_vector(const Vec3& v) {
  return {v.x, v.y, v.z};
}

btTransform bullet_transform(const Pose& pose) {
  const Quat& q = pose.orientation;
  return btTransform(btQuaternion(q.x, q.y, q.z, q.w), bullet_vector(pose.position));
}

Shaped bullet_shape(const HullShape& hull) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& v : hull.vertices) shape->addPoint(bullet_vector(v), false);
  shape->recalcLocalAabb();
  return shape;
}

Shaped bullet_shape(const Sphere& sphere) {
  return std::make_unique<btSphereShape>(sphere.radius);
}

Shaped bullet_shape(const Box& box) {
  return std::make_unique<btBoxShape>(bullet_vector(box.half_extents));
}

Shaped bullet_shape(const Capsule& capsule) {
  return std::make_unique<btCapsuleShapeZ>(capsule.radius, capsule.height);
}

Shaped bullet_shape(const Cylinder& cylinder) {
  const Real r = cylinder.radius;
  return std::make_unique<btCylinderShapeZ>(btVector3(r, r, cylinder.height / 2));
}

// Of shapes that are not in these files
template <class Other>
Shaped bullet_shape(const Other&) {
  return nullptr;
}

// Balls and capsules are all margin; the others get none
Shaped without_margin(const Shape& shape) {
  Shaped made = std::visit([](const auto& s) { return bullet_shape(s); }, shape);
  const bool is_round =
      std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape);
  if (!is_round) made->setMargin(0);
  return made;
}

}  // namespace

PeerAnswer ask_bullet(const chapter_04::PlacedPair& pair) {
  const Shaped a = without_margin(pair.a.shape), b = without_margin(pair.b.shape);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;
  btGjkPairDetector detector(a.get(), b.get(), &simplex, &epa);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = bullet_transform(pair.a.pose);
  input.m_transformB = bullet_transform(pair.b.pose);
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  if (!result.m_hasResult) return {};
  return {result.m_distance};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
