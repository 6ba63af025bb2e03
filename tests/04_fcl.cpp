// Chapter 4's signed distances beside FCL's, which finds those of primitive shapes by
// libccd's GJK and an EPA of its own, some pairs by formula. In double, as FCL is here.
// Few pairs overlap deeply: on some of those, and of sizes a hundred times as large as
// each other, FCL 0.7 ends the whole program with a failed assertion.
#include <memory>

#include <fcl/fcl.h>

#include "tests/catch.hpp"
#include "tests/shape_pairs.hpp"

using namespace timestep;

namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

// The frames are the same but a cone's: FCL has its middle at z = 0
Geometry fcl_geometry(const Shape& shape) {
  struct Make {
    Geometry operator()(const Sphere& s) const {
      return std::make_shared<fcl::Sphered>(s.radius);
    }
    Geometry operator()(const Box& s) const {
      const Vec3 size = Real(2) * s.half_extents;
      return std::make_shared<fcl::Boxd>(size.x, size.y, size.z);
    }
    Geometry operator()(const Ellipsoid& s) const {
      return std::make_shared<fcl::Ellipsoidd>(s.semi_axes.x, s.semi_axes.y,
                                               s.semi_axes.z);
    }
    Geometry operator()(const Capsule& s) const {
      return std::make_shared<fcl::Capsuled>(s.radius, s.height);
    }
    Geometry operator()(const Cylinder& s) const {
      return std::make_shared<fcl::Cylinderd>(s.radius, s.height);
    }
    Geometry operator()(const Cone& s) const {
      return std::make_shared<fcl::Coned>(s.radius, s.height);
    }
    Geometry operator()(const HalfSpace&) const { return nullptr; }
    Geometry operator()(const HullShape&) const { return nullptr; }
  };
  return std::visit(Make{}, shape);
}

fcl::Transform3d fcl_transform(const Shape& shape, const Pose& pose) {
  const auto* cone = std::get_if<Cone>(&shape);
  const Vec3 middle(0, 0, cone == nullptr ? 0 : cone->height / 2);
  const Vec3 at = point_in_world(pose, middle);
  const Quat& q = pose.orientation;
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  transform.translation() = fcl::Vector3d(at.x, at.y, at.z);
  return transform;
}

double fcl_distance(const Pair& p) {
  const fcl::CollisionObjectd a(fcl_geometry(p.a), fcl_transform(p.a, p.pose_a));
  const fcl::CollisionObjectd b(fcl_geometry(p.b), fcl_transform(p.b, p.pose_b));
  fcl::DistanceRequestd request(true, true);
  request.distance_tolerance = 1e-8;
  fcl::DistanceResultd result;
  return fcl::distance(&a, &b, request, result);
}

}  // namespace

TEST_CASE("FCL finds the same signed distances") {
  Random random(12);
  int overlapping = 0;
  for (int i = 0; i < 3600; ++i) {
    Pair p;
    p.a = random_shape(random, i % 6, 1, p.points[0]);
    p.b = random_shape(random, i / 6 % 6, random.log_between(0.2, 5), p.points[1]);
    p.pose_a.orientation = random.turn();
    p.pose_b = {random.in_cube(3), random.turn()};
    const Separation s = separation_of(p);
    overlapping += s.distance < 0;

    // FCL's tolerance is absolute: below, 1e-8; its EPA stops at smooth shapes sooner
    INFO(i << " " << k_shape_names[p.a.index()] << " " << k_shape_names[p.b.index()]);
    const double within = 1e-5 + double(s.error);
    CHECK(fcl_distance(p) == Approx(double(s.distance)).margin(within));
  }
  CHECK(overlapping > 400);
}
