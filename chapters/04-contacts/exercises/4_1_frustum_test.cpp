// What the frustum reaches along a direction is known: the greater of its two discs'
// reaches. And a support point has to be a point of the frustum.
#include "chapters/04-contacts/exercises/4_1_frustum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// Ten roundings of numbers as large as the frustum
constexpr double k_roundings = 10 * k_u;

void expect_support(const Frustum& f, const Vec3& d) {
  const std::string what =
      fmt::format("the frustum {} m, {} m, {} m high along ({:.3g}, {:.3g}, {:.3g})",
                  f.lower, f.upper, f.height, d.x, d.y, d.z);
  const double size = std::max({f.lower, f.upper, f.height});
  const Vec3 p = support(f, d);
  if (!std::isfinite(p.x + p.y + p.z)) FAIL("not finite: the support point of " + what);

  const double length =
      std::max(std::hypot(d.x, d.y, d.z), std::numeric_limits<double>::min());
  const double across = std::hypot(d.x, d.y);
  const double reach = std::max(f.lower * across, f.upper * across + f.height * d.z);
  expect("reach [m] of " + what, glm::dot(d / length, p), reach / length,
         k_roundings * size);

  const double at = std::clamp(p.z, 0.0, f.height);
  expect("height [m] of the support point of " + what, p.z, at, k_roundings * size);
  const double widest = f.lower + (f.upper - f.lower) * at / f.height;
  const double radius = std::hypot(p.x, p.y);
  expect("radius [m] of the support point of " + what, radius, std::min(radius, widest),
         k_roundings * size);
}

}  // namespace

TEST_CASE("a bucket, wider above than below") {
  const Frustum bucket{1, 2, 3};
  for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, 1, 0.1), Vec3(-1, 1, -0.2),
                        Vec3(0.3, 0.4, -0.5), Vec3(1, 2, -30)})
    expect_support(bucket, d);
}

TEST_CASE("straight up, straight down and nowhere") {
  for (const Frustum& f : {Frustum{1, 2, 3}, {2, 1, 3}, {1, 0, 1}})
    for (const Vec3& d : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 0, 0)})
      expect_support(f, d);
}

TEST_CASE("any frustum, and directions of any length") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Frustum f{random.between(0, 2), random.between(0, 2), random.between(0.1, 2)};
    expect_support(f, random.log_between(1e-200, 1e200) * random.direction());
  }
}
