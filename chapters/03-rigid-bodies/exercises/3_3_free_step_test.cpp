// Euler's equations on whole numbers; then what free bodies keep, and how they stand
// after a while by the exact solutions (3.29) and (3.31), in numbers from arithmetic of
// many digits.
#include "chapters/03-rigid-bodies/exercises/3_3_free_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "common/physics/exact_top.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

// A free body along the world's axes, and the orientation that it has t seconds later
struct Free {
  std::string_view what;
  Vec3 I, omega;
  Real t;
  Quat q;
};

const std::array<Free, 4> k_free{{
    {.what = "a long symmetrical body",
     .I = {1, 1, 0.25},
     .omega = {0, 3, 10},
     .t = 0.5,
     .q = {0.6737623072103589, -0.6071897443161282, 0.19062612245464053,
           -0.3755351504424017}},
    {.what = "a flat symmetrical body",
     .I = {1, 1, 1.8},
     .omega = {0, 3, 10},
     .t = 0.5,
     .q = {0.824492731794998, -0.14780190100198784, -0.06764265654237085,
           -0.5420247266438228}},
    {.what = "a body with three different moments",
     .I = {1, 2, 2.5},
     .omega = {0.4, 1, 0.8},
     .t = 5,
     .q = {0.7715773115629998, -0.605063836969635, 0.18432224261079316,
           -0.0677607286835418}},
    {.what = "a body that flips",
     .I = {1, 2, 2.5},
     .omega = {0.1, 2, 0.3},
     .t = 5,
     .q = {0.08240963903017955, 0.059360639979841374, -0.19082386587904293,
           -0.9763560918164418}},
}};

// The angle between how a body stands after so many steps and how it ought to
Real attitude_error(const Free& body, int steps) {
  Rotation r{.omega = body.omega};
  for (int i = 0; i < steps; ++i) free_step(r, body.I, body.t / steps);
  return exact::angle_between(body.q, r.q);
}

void expect_order(const Free& body, Real least) {
  // The next term of the series is smaller by dt times the fastest rate, 1/40 or less
  const Real coarse = attitude_error(body, 400);
  const Real order = std::log2(coarse / attitude_error(body, 800));
  expect(fmt::format("order in dt (up to {}) of the attitude of {}, which after 400 "
                     "steps in {} s is off by {:.3g} rad",
                     least, body.what, body.t, coarse),
         std::min(order, least), least, 0.05);
}

}  // namespace

TEST_CASE("Euler's equations") {
  const auto alpha = [](const Vec3& I, const Vec3& tau) {
    return angular_acceleration({1, 2, 3}, I, tau);
  };
  const std::string what = "angular acceleration [rad/s²] at omega = (1, 2, 3) rad/s ";
  expect(what + "with I = (1, 2, 4) kg m² and no torque", alpha({1, 2, 4}, Vec3(0)),
         {-12, 4.5, -0.5}, 0);
  expect(what + "with I = (1, 2, 4) kg m² and tau = (1, 2, 3) N m",
         alpha({1, 2, 4}, {1, 2, 3}), {-11, 5.5, 0.25}, 0);
  expect(what + "with I = (2, 2, 2) kg m² and tau = (2, 4, 6) N m",
         alpha({2, 2, 2}, {2, 4, 6}), {1, 2, 3}, 0);
}

TEST_CASE("the angular momentum keeps its length and its direction") {
  for (const Free& body : k_free) {
    Rotation r{.omega = body.omega};
    const Vec3 L = angular_momentum(r, body.I);
    for (int i = 1; i <= 1000; ++i) {
      free_step(r, body.I, 0.01);

      // A step turns q and omega, with two dozen roundings each
      const std::string after =
          fmt::format("{}, after step {} of 0.01 s", body.what, i);
      const Real tolerance = i * 64 * k_u;
      const Vec3 now = angular_momentum(r, body.I);
      expect("length of q of " + after, glm::length(r.q), 1, tolerance);
      expect("length of L [kg m²/s] of " + after, glm::length(now), glm::length(L),
             tolerance * glm::length(L));
      expect("L [kg m²/s] in the world of " + after, now, L,
             tolerance * glm::length(L));
    }
  }
}

TEST_CASE("half the step leaves half of the error, or less") {
  for (const Free& body : k_free) expect_order(body, 1);
}

TEST_CASE("half the step leaves a quarter of the error") {
  for (const Free& body : k_free) expect_order(body, 2);
}
