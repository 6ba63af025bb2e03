// A box, where one can see the answer, and hulls on a ball, where the point that is hit
// has to be on the hull and nothing of the ray before it may be.
#include "chapters/04-contacts/exercises/4_4_ray.hpp"

#include <algorithm>
#include <limits>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// How far above its highest plane a point is [m]: negative inside
double height(const ConvexHull& hull, const Vec3& p) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : hull.planes)
    most = std::max(most, glm::dot(plane.normal, p) - plane.offset);
  return most;
}

void expect_miss(const std::string& what, const std::optional<RayHit>& yours) {
  if (yours)
    FAIL(fmt::format("{}: yours hits at t = {:.8g}, it misses", what, yours->t));
}

RayHit expect_hit(const std::string& what, const std::optional<RayHit>& yours) {
  if (!yours) FAIL(what + ": yours misses, it hits");
  return *yours;
}

}  // namespace

TEST_CASE("a ray straight onto a box") {
  const ConvexHull box = box_hull({1, 2, 3});
  const RayHit hit = expect_hit("from the right", cast_ray(box, {5, 0, 0}, {-2, 0, 0}));
  expect("t of the ray from the right", hit.t, 2, 4 * k_u);
  expect("the normal there", hit.normal, {1, 0, 0}, 4 * k_u);
  const RayHit slanted =
      expect_hit("a slanted ray", cast_ray(box, {-3, 0.5, 3}, {1, 0, -0.5}));
  expect("t of the slanted ray", slanted.t, 2, 4 * k_u);
  expect("the normal there", slanted.normal, {-1, 0, 0}, 4 * k_u);
}

TEST_CASE("rays that miss a box") {
  const ConvexHull box = box_hull({1, 2, 3});
  expect_miss("a ray that goes away", cast_ray(box, {5, 0, 0}, {1, 0, 0}));
  expect_miss("a ray beside a face", cast_ray(box, {-5, 2.1, 0}, {1, 0, 0}));
  expect_miss("a ray past an edge", cast_ray(box, {-3, 0, 0}, {1, 1.5, 0}));
}

TEST_CASE("a ray that starts inside") {
  const RayHit hit =
      expect_hit("from inside", cast_ray(box_hull({1, 2, 3}), {0.5, 1, 2}, {1, 1, 1}));
  expect("t of the ray from inside", hit.t, 0, 0);
  expect("the normal there", hit.normal, {0, 0, 0}, 0);
}

TEST_CASE("any ray against any hull") {
  // A hit is on the surface, and half a rounding's way before it the ray is outside; a
  // miss is outside everywhere, of which we look at a thousand places
  Random random(4);
  int hits = 0, misses = 0;
  for (int i = 0; i < 300; ++i) {
    const ConvexHull hull = random_hull(random, 30);
    const Vec3 origin = 3.0 * random.direction();
    const Vec3 direction =
        random.log_between(0.1, 10) * glm::normalize(random.in_cube() - origin);
    const std::string what = fmt::format("ray {}", i);
    const std::optional<RayHit> yours = cast_ray(hull, origin, direction);
    if (!yours) {
      ++misses;
      for (int k = 0; k < 1000; ++k) {
        const Vec3 p = origin + 0.006 * k / glm::length(direction) * direction;
        if (height(hull, p) < -1e-12) FAIL(what + ": yours misses, it hits");
      }
      continue;
    }
    ++hits;
    const Vec3 p = origin + yours->t * direction;
    expect("height [m] above the hull of the point that is hit, " + what,
           height(hull, p), 0, 1e-12);
    const Vec3 before = p - 1e-6 / glm::length(direction) * direction;
    if (!(height(hull, before) > 0)) FAIL(what + ": yours goes through the hull");
    expect("height [m] of that point above the face of its normal, " + what,
           glm::dot(yours->normal, p)
               - glm::dot(
                   yours->normal,
                   hull.vertices[support_vertex(hull_shape(hull), yours->normal, 0)]),
           0, 1e-12);
  }
  REQUIRE(hits > 50);
  REQUIRE(misses > 50);
}
