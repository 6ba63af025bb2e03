// Balls and boxes on straight paths, whose first touch has a closed form.
#include "chapters/04-contacts/exercises/4_3_time_of_impact.hpp"

#include <cmath>
#include <string>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

constexpr Real k_within = 1e-6;

// A time is right if they are then between 0 and `within` apart, give or take a
// rounding
void expect_time(const std::string& what, std::optional<Real> yours, double touching,
                 double speed) {
  if (!yours) FAIL("no time for " + what + fmt::format(", right is {:.8g}", touching));
  const double early = 2 * k_within / speed;
  expect("time [s] of " + what, *yours, touching - early / 2, early / 2 + 1e-12);
}

}  // namespace

TEST_CASE("a bullet does not pass through a wall") {
  const Shape bullet = Sphere{0.005}, wall = Box{{0.01, 2, 2}};
  const Moving a{convex(bullet), {{-5, 0.3, 0.1}, {1, 0, 0, 0}}, {900, 0, 0}};
  const Moving b{convex(wall), {}, {0, 0, 0}};
  expect_time("the bullet", time_of_impact(a, b, 1, k_within), (5 - 0.015) / 900, 900);
  expect_time("the wall that meets the bullet", time_of_impact(b, a, 1, k_within),
              (5 - 0.015) / 900, 900);
}

TEST_CASE("what flies apart or past never touches") {
  const Shape ball = Sphere{0.5};
  const Moving still{convex(ball), {}, {0, 0, 0}};
  for (const Vec3& v : {Vec3(1, 0, 0), Vec3(0, 3, 0), Vec3(-3, 2, 0), Vec3(0, 0, 0)}) {
    const Moving other{convex(ball), {{3, 0, 0}, {1, 0, 0, 0}}, v};
    if (time_of_impact(still, other, 100, k_within))
      FAIL(fmt::format("a time for a ball that flies past with ({}, {}, {}) m/s", v.x,
                       v.y, v.z));
  }
}

TEST_CASE("not before the end, and at once if they touch") {
  const Shape ball = Sphere{0.5};
  const Moving a{convex(ball), {}, {1, 0, 0}};
  const Moving far{convex(ball), {{3, 0, 0}, {1, 0, 0, 0}}, {0, 0, 0}};
  const Moving near{convex(ball), {{0.75, 0, 0}, {1, 0, 0, 0}}, {0, 0, 0}};
  if (time_of_impact(a, far, 1.99, k_within)) FAIL("a time after the end");
  expect_time("two balls 2 m apart", time_of_impact(a, far, 2.01, k_within), 2, 1);
  const std::optional<Real> now = time_of_impact(a, near, 1, k_within);
  if (!now) FAIL("no time for balls that overlap from the start");
  expect("time [s] of balls that overlap", *now, 0, 0);
}

TEST_CASE("balls that graze each other") {
  // (p + t v)² = d², where d is what they have to come to
  Random random(3);
  const Shape ball = Sphere{0.5};
  int grazing = 0;
  for (int i = 0; i < 300; ++i) {
    const double beside =
        i % 3 == 0 ? 1 - random.log_between(1e-5, 1e-2) : random.between(0, 0.9);
    const double speed = random.log_between(0.1, 1000);
    const Moving a{convex(ball), {{-10, beside, 0}, {1, 0, 0, 0}}, {speed, 0, 0}};
    const Moving b{convex(ball), {}, {0, 0, 0}};
    const std::optional<Real> yours = time_of_impact(a, b, 1e6, k_within);
    const auto time_at = [&](double d) {
      return (10 - std::sqrt(d * d - beside * beside)) / speed;
    };
    const std::string what =
        fmt::format("ball {}, {:.6g} m beside the other", i, beside);
    if (!yours) FAIL("no time for " + what);
    grazing += beside > 0.99;
    const double early = time_at(1 + 2 * k_within), late = time_at(1);
    expect("time [s] of " + what, *yours, (early + late) / 2,
           (late - early) / 2 + 1e-12 * late);
  }
  REQUIRE(grazing > 50);
}
