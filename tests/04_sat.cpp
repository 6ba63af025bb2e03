// Chapter 4's separating axis test: against exact pairs, against every axis that there
// is, and boxes against hulls. Compiled for each precision; u (k_u) is the unit
// round-off of the one at hand.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "common/physics/sat.hpp"
#include "tests/catch.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

using Json = nlohmann::json;

std::vector<glm::dvec3> points_of(const Json& shape) {
  std::vector<glm::dvec3> points;
  for (const Json& v : shape["vertices"])
    points.emplace_back(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
  return points;
}

// About its own first vertex, which is what far shapes lose no digits by
struct Placed {
  HullResult result;
  glm::dvec3 at;
};

Placed placed_hull(const std::vector<glm::dvec3>& points) {
  std::vector<Vec3> local;
  for (const glm::dvec3& p : points) local.emplace_back(p - points[0]);
  return {convex_hull(local), points[0]};
}

std::vector<glm::dvec3> directions(const ConvexHull& hull, const Pose& pose,
                                   bool of_edges) {
  const glm::dquat q(pose.orientation);
  std::vector<glm::dvec3> found;
  if (!of_edges)
    for (const Plane& plane : hull.planes)
      found.push_back(q * glm::dvec3(plane.normal));
  else
    for (const HalfEdge& e : hull.half_edges)
      found.push_back(q
                      * glm::dvec3(hull.vertices[hull.half_edges[e.next].origin]
                                   - hull.vertices[e.origin]));
  return found;
}

// The largest gap along any face normal or across any two edges, both ways
double brute_force(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
                   const Pose& pose_b) {
  std::vector<glm::dvec3> axes = directions(a, pose_a, false);
  for (const glm::dvec3& n : directions(b, pose_b, false)) axes.push_back(-n);
  for (const glm::dvec3& e : directions(a, pose_a, true)) {
    for (const glm::dvec3& f : directions(b, pose_b, true)) {
      const glm::dvec3 n = glm::cross(e, f);
      if (glm::length(n) > 1e-9 * glm::length(e) * glm::length(f)) axes.push_back(n);
    }
  }
  double most = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& n : axes)
    most = std::max(most, gap_along(a, pose_a, b, pose_b, glm::normalize(n)));
  return most;
}

Pose random_pose(Random& random, double distance) {
  return {random.direction() * Real(distance), random.turn()};
}

// How the result contradicts itself, in units of u and size
double inconsistency(const ConvexHull& a, const Pose& pose_a, const ConvexHull& b,
                     const Pose& pose_b, const Separation& s, double size) {
  const double gap = gap_along(a, pose_a, b, pose_b, glm::dvec3(s.normal));
  const glm::dvec3 between = glm::dvec3(s.on_b) - glm::dvec3(s.on_a);
  const double witnesses =
      glm::distance(between, double(s.distance) * glm::dvec3(s.normal));
  return std::max(std::abs(gap - double(s.distance)), witnesses) / (k_u * size);
}

}  // namespace

TEST_CASE("exact pairs: depths are right, and separated pairs are told apart") {
  std::ifstream file(TIMESTEP_TRUTH "/geometry_public.json");
  const Json cases = Json::parse(file)["cases"];
  int overlapping = 0, separated = 0, flat = 0;
  for (const Json& c : cases) {
    const Placed a = placed_hull(points_of(c["inputs"]["A"]));
    const Placed b = placed_hull(points_of(c["inputs"]["B"]));
    flat += !a.result.fault.empty() || !b.result.fault.empty();
    if (!a.result.fault.empty() || !b.result.fault.empty()) continue;
    const ConvexHull &hull_a = a.result.hull, &hull_b = b.result.hull;
    const Pose pose_b{.position = Vec3(b.at - a.at)};
    const Separation s = sat(hull_a, {}, hull_b, pose_b).separation;

    // In single, every vertex and the position are off by u times their size
    const double exact = c["expected"]["signed_distance"].get<double>();
    const double size = hull_a.reach + hull_b.reach + glm::length(pose_b.position);
    const double tol = c["tol"]["abs"].get<double>()
                       + std::abs(exact) * c["tol"]["rel"].get<double>()
                       + (k_u > 1e-10 ? 8 * k_u * size : 0);
    INFO(c["id"] << ": " << s.distance << ", exactly " << exact);
    if (exact > 0) {
      ++separated;
      CHECK(s.distance <= exact + tol);
      CHECK((exact <= tol || s.distance > 0));
    } else {
      ++overlapping;
      CHECK(std::abs(s.distance - exact) <= tol);
    }
    CHECK(inconsistency(hull_a, {}, hull_b, pose_b, s, size) < 16);
  }
  CHECK(overlapping + separated + flat == int(cases.size()));
  CHECK(overlapping >= 150);
  CHECK(separated >= 130);
}

TEST_CASE("no axis is better than the one that is found") {
  Random random(1);
  int overlapping = 0, faces = 0, edges = 0;
  for (int i = 0; i < 2000; ++i) {
    const ConvexHull a = random_hull(random, 4 + i % 9);
    const ConvexHull b = random_hull(random, 4 + i % 7);
    const Pose pose_a = random_pose(random, 0.2);
    const Pose pose_b = random_pose(random, random.between(0.1, 1.2));
    const SatResult result = sat(a, pose_a, b, pose_b);
    const Separation& s = result.separation;
    const double size =
        a.reach + b.reach + glm::distance(pose_a.position, pose_b.position);
    INFO(i);
    const double best = brute_force(a, pose_a, b, pose_b);
    if (best < 0)
      CHECK(std::abs(s.distance - best) <= 64 * k_u * size);
    else
      CHECK(s.distance > -64 * k_u * size);
    CHECK(inconsistency(a, pose_a, b, pose_b, s, size) < 16);
    overlapping += best < 0;
    (result.feature == SatFeature::edges ? edges : faces) += best < 0;
  }
  CHECK(overlapping > 700);
  CHECK(faces > 200);
  CHECK(edges > 200);
}

TEST_CASE("two boxes are two hulls, with fewer axes") {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    // Any turn, none, a quarter, or all but one of those
    const auto pose = [&] {
      Pose p = random_pose(random, random.between(0, 1));
      if (i % 4 == 1) p.orientation = Quat(1, 0, 0, 0);
      if (i % 4 == 2) p.orientation = glm::normalize(Quat(1, 0, 1, 0));
      if (i % 4 == 3)
        p.orientation =
            rotation_by(random.direction() * Real(random.log_between(1e-17, 1e-3)));
      return p;
    };
    const Box a{random.sizes(0.01, 1)}, b{random.sizes(0.01, 1)};
    const ConvexHull hull_a = box_hull(a.half_extents),
                     hull_b = box_hull(b.half_extents);
    const Pose pose_a = pose(), pose_b = pose();
    const SatResult boxes = sat(a, pose_a, b, pose_b);
    const SatResult hulls = sat(hull_a, pose_a, hull_b, pose_b);
    const double size =
        hull_a.reach + hull_b.reach + glm::distance(pose_a.position, pose_b.position);
    INFO(i);
    const bool both_apart =
        boxes.separation.distance > 0 && hulls.separation.distance > 0;
    CHECK((both_apart
           || std::abs(boxes.separation.distance - hulls.separation.distance)
                  < 64 * k_u * size));
    CHECK(inconsistency(hull_a, pose_a, hull_b, pose_b, boxes.separation, size) < 32);
    CHECK(boxes.axes == 15);
    CHECK(hulls.edge_pairs == 144);
  }
}

TEST_CASE(
    "moved by a little more than the depth, they are apart; by less, they are not") {
  Random random(3);
  int tried = 0;
  for (int i = 0; i < 1000; ++i) {
    const ConvexHull a = random_hull(random, 6 + i % 20);
    const ConvexHull b = random_hull(random, 6 + i % 20);
    Pose pose_b = random_pose(random, random.between(0, 1));
    const Separation s = sat(a, {}, b, pose_b).separation;
    if (s.distance > -1e-3) continue;
    ++tried;
    const Vec3 start = pose_b.position;
    pose_b.position = start - Real(1.01) * s.distance * s.normal;
    CHECK(sat(a, {}, b, pose_b).separation.distance > 0);
    pose_b.position = start - Real(0.99) * s.distance * s.normal;
    CHECK(sat(a, {}, b, pose_b).separation.distance < 0);
  }
  CHECK(tried > 500);
}

TEST_CASE("axes grow with the product of the edges, as the thesis says") {
  Random random(4);
  const auto sphere = [&](int n) {
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) points.push_back(random.direction());
    return convex_hull(points).hull;
  };
  for (const int n : {8, 16, 32, 64}) {
    // Of n vertices: 3 n - 6 edges, 2 n - 4 faces
    const SatResult result = sat(sphere(n), {}, sphere(n), {.position = {1, 0, 0}});
    CHECK(result.edge_pairs == std::int64_t(3 * n - 6) * (3 * n - 6));
    CHECK(result.axes >= 2 * (2 * n - 4));
    CHECK(result.axes < 2 * (2 * n - 4) + result.edge_pairs / 4);
  }
}
