// FCL's depths, as it comes: by libccd's MPR but for the pairs that it has a formula
// for. Its signed distance ends the program by an assertion in some of these pairs. Not
// asked for ellipsoids, cones and half-spaces.
#include <algorithm>
#include <memory>
#include <variant>

#include <fcl/fcl.h>

#include "study/peers/pairs.hpp"

namespace timestep::study {
namespace {

constexpr std::size_t k_most_contacts = 8;

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

fcl::Vector3d fcl_vector(const Vec3& v) {
  return {v.x, v.y, v.z};
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

// Without faces its support function looks at each vertex
Geometry fcl_geometry(const HullShape& hull) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vec3& v : hull.vertices) vertices->push_back(fcl_vector(v));
  return std::make_shared<fcl::Convexd>(vertices, 0,
                                        std::make_shared<std::vector<int>>());
}

template <class Other>
Geometry fcl_geometry(const Other&) {
  return nullptr;
}

Geometry geometry_of(const chapter_04::Specimen& specimen) {
  return std::visit([](const auto& shape) { return fcl_geometry(shape); },
                    specimen.shape);
}

void move(fcl::CollisionObjectd& object, const Pose& pose) {
  const Quat& q = pose.orientation;
  object.setTransform(fcl::Quaterniond(q.w, q.x, q.y, q.z), fcl_vector(pose.position));
}

AskPair prepare(const chapter_04::Specimen& like_a,
                const chapter_04::Specimen& like_b) {
  const Geometry shape_a = geometry_of(like_a), shape_b = geometry_of(like_b);
  if (!shape_a || !shape_b) return {};
  const auto a = std::make_shared<fcl::CollisionObjectd>(shape_a);
  const auto b = std::make_shared<fcl::CollisionObjectd>(shape_b);
  return [a, b](const Pose& pose_a, const Pose& pose_b) {
    move(*a, pose_a);
    move(*b, pose_b);
    const fcl::CollisionRequestd request(k_most_contacts, true);
    fcl::CollisionResultd result;
    fcl::collide(a.get(), b.get(), request, result);
    double deepest = 0;
    for (std::size_t i = 0; i < result.numContacts(); ++i)
      deepest = std::max(deepest, result.getContact(i).penetration_depth);
    return -deepest;
  };
}

}  // namespace

std::vector<Peer> peers_of_fcl() {
  return {{.method = "fcl", .precision = "double", .start = [](const auto& setup) {
             return start_pairs(setup, prepare);
           }}};
}

}  // namespace timestep::study
