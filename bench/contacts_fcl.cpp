// The pairs by FCL, as it comes: depths by libccd's MPR but for the pairs that it has a
// formula for. FCL_signed is its signed distance, by libccd's EPA. In double.
#include <memory>

#include <fcl/fcl.h>

#include "bench/contacts.hpp"
#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using namespace contact_bench;

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

fcl::Vector3d fcl_vector(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

fcl::Transform3d fcl_transform(const Place& place) {
  const glm::dquat& q = place.orientation;
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  transform.translation() = fcl_vector(place.position);
  return transform;
}

Geometry fcl_hull(const Solid& solid) {
  const ConvexHull hull = convex_hull(solid.vertices).hull;
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vec3& v : hull.vertices) vertices->push_back(fcl_vector(v));
  auto faces = std::make_shared<std::vector<int>>();
  for (std::size_t f = 0; f < hull.planes.size(); ++f) {
    faces->push_back(int(hull.face_start[f + 1] - hull.face_start[f]));
    for (auto e = hull.face_start[f]; e < hull.face_start[f + 1]; ++e)
      faces->push_back(int(hull.half_edges[e].origin));
  }
  return std::make_shared<fcl::Convexd>(vertices, int(hull.planes.size()), faces);
}

Geometry fcl_geometry(const Solid& solid) {
  if (solid.radius > 0) return std::make_shared<fcl::Sphered>(solid.radius);
  if (solid.vertices.empty())
    return std::make_shared<fcl::Boxd>(fcl_vector(2.0 * solid.half_extents));
  return fcl_hull(solid);
}

struct Pair {
  fcl::CollisionObjectd a, b;
};

struct Fcl {
  std::vector<Pair> pairs;

  Fcl(std::span<const SolidPair> solid_pairs, std::span<const Solid> solids) {
    std::vector<Geometry> geometries;
    for (const Solid& solid : solids) geometries.push_back(fcl_geometry(solid));
    for (const SolidPair& p : solid_pairs)
      pairs.push_back({{geometries[p.a], fcl_transform(p.place_a)},
                       {geometries[p.b], fcl_transform(p.place_b)}});
  }
};

// Up to so many contact points; none asks for no more than whether there are any
struct Collide {
  Fcl fcl;
  std::size_t most_contacts;

  double ask(std::size_t i) const {
    const auto& [a, b] = fcl.pairs[i];
    const std::size_t most = std::max<std::size_t>(most_contacts, 1);
    const fcl::CollisionRequestd request(most, most_contacts > 0);
    fcl::CollisionResultd result;
    if (fcl::collide(&a, &b, request, result) == 0) return 1;
    if (most_contacts == 0) return -1;
    double deepest = 0;
    for (std::size_t k = 0; k < result.numContacts(); ++k)
      deepest = std::max(deepest, result.getContact(k).penetration_depth);
    return -deepest;
  }
};

struct Distance {
  Fcl fcl;
  bool has_sign;

  double ask(std::size_t i) const {
    const auto& [a, b] = fcl.pairs[i];
    const fcl::DistanceRequestd request(true, has_sign);
    fcl::DistanceResultd result;
    return fcl::distance(&a, &b, request, result);
  }
};

template <class Library>
void add(const NamedSet& set, Question question, const std::string& name, auto option) {
  add_contacts(set, question, name + "/double",
               [=](std::span<const SolidPair> pairs, std::span<const Solid> solids) {
                 return Library{{pairs, solids}, option};
               });
}

}  // namespace

void add_contacts_of_fcl() {
  for (const NamedSet& set : {k_sphere_box, k_box_box, k_hull32, k_hull1000}) {
    add<Collide>(set, Question::boolean, "FCL", std::size_t{0});
    add<Distance>(set, Question::distance, "FCL", false);
    add<Collide>(set, Question::depth, "FCL", std::size_t{1});
    add<Distance>(set, Question::depth, "FCL_signed", true);
  }
  add<Collide>(k_box_box, Question::manifold, "FCL", std::size_t{8});
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
