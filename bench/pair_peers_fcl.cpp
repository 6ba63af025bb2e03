// FCL about the pairs of truth files.
#include <cmath>
#include <memory>
#include <type_traits>

#include <fcl/fcl.h>

#include "bench/pair_peers.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

fcl::Vector3d fcl_vector(const Vec3& v) {
  return {v.x, v.y, v.z};
}

fcl::Transform3d fcl_transform(const Pose& pose) {
  const Quat& q = pose.orientation;
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  transform.translation() = fcl_vector(pose.position);
  return transform;
}

// Without faces its support function looks at each vertex
Geometry fcl_geometry(const HullShape& hull) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vec3& v : hull.vertices) vertices->push_back(fcl_vector(v));
  return std::make_shared<fcl::Convexd>(vertices, 0,
                                        std::make_shared<std::vector<int>>());
}

Geometry fcl_geometry(const Sphere& sphere) {
  return std::make_shared<fcl::Sphered>(sphere.radius);
}

Geometry fcl_geometry(const Box& box) {
  return std::make_shared<fcl::Boxd>(fcl_vector(2.0 * box.half_extents));
}

Geometry fcl_geometry(const Capsule& capsule) {
  return std::make_shared<fcl::Capsuled>(capsule.radius, capsule.height);
}

Geometry fcl_geometry(const Cylinder& cylinder) {
  return std::make_shared<fcl::Cylinderd>(cylinder.radius, cylinder.height);
}

// Of shapes that are not in these files
template <class Other>
Geometry fcl_geometry(const Other&) {
  return nullptr;
}

fcl::CollisionObjectd fcl_object(const chapter_04::PlacedShape& placed) {
  const Geometry geometry =
      std::visit([](const auto& shape) { return fcl_geometry(shape); }, placed.shape);
  return {geometry, fcl_transform(placed.pose)};
}

}  // namespace

PeerAnswer ask_fcl(const chapter_04::PlacedPair& pair) {
  try {
    const fcl::CollisionObjectd a = fcl_object(pair.a), b = fcl_object(pair.b);
    fcl::DistanceRequestd request(true, true);
    request.distance_tolerance = 1e-9;
    fcl::DistanceResultd result;
    return {fcl::distance(&a, &b, request, result)};
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
