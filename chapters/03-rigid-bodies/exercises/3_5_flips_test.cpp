// Rates with closed forms, and intervals of (3.32) in numbers from arithmetic of many
// digits: motions about either stable axis, in several orders of the axes, and the
// tumbling that begins with a tiny wobble.
#include "chapters/03-rigid-bodies/exercises/3_5_flips.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

struct Flips {
  Vec3 I, omega;
  Real interval;
};

std::string of_body(const Vec3& I, const Vec3& omega) {
  return fmt::format("with I = ({}, {}, {}) kg m², omega = ({}, {}, {}) rad/s", I.x,
                     I.y, I.z, omega.x, omega.y, omega.z);
}

}  // namespace

TEST_CASE("the unstable axis is that of the middle moment") {
  struct Row {
    Vec3 I;
    int axis;
  };
  for (const auto& [I, axis] : {Row{{1, 2, 3}, 1},
                                {{1, 3, 2}, 2},
                                {{2, 1, 3}, 0},
                                {{2, 3, 1}, 0},
                                {{3, 1, 2}, 2},
                                {{3, 2, 1}, 1}})
    expect(fmt::format("unstable axis of I = ({}, {}, {}) kg m²", I.x, I.y, I.z),
           unstable_axis(I), axis, 0);
}

TEST_CASE("how fast a wobble grows") {
  expect("growth rate [1/s] with I = (1, 2, 2.5) kg m², W = 5 rad/s",
         growth_rate({1, 2, 2.5}, 5), std::sqrt(5.0), 16 * k_u * std::sqrt(5.0));
  expect("growth rate [1/s] with I = (4, 7, 5) kg m², W = 2 rad/s",
         growth_rate({4, 7, 5}, 2), 2 / std::sqrt(14.0), 16 * k_u);
  expect("growth rate [1/s] with I = (4, 7, 5) kg m², W = -2 rad/s",
         growth_rate({4, 7, 5}, -2), 2 / std::sqrt(14.0), 16 * k_u);
}

TEST_CASE("near a stable axis, half the period of a small wobble") {
  // Omega circles the axis at W sqrt((I3 - I1) (I3 - I2) / (I1 I2)) and so on, but for
  // the square of the wobble
  const Vec3 I{1, 2, 2.5};
  const Real about_3 = std::numbers::pi / (4 * std::sqrt(1.5 * 0.5 / 2));
  expect("interval [s] " + of_body(I, {1e-9, 0, 4}), flip_interval(I, {1e-9, 0, 4}),
         about_3, 32 * k_u * about_3);
  const Real about_1 = std::numbers::pi / (4 * std::sqrt(1 * 1.5 / 5));
  expect("interval [s] " + of_body(I, {4, 0, 1e-9}), flip_interval(I, {4, 0, 1e-9}),
         about_1, 32 * k_u * about_1);
}

TEST_CASE("the interval of any motion") {
  // 1 - kappa² is at least 1/30, and may be the difference of numbers near 1
  for (const auto& [I, omega, interval] :
       {Flips{{1, 2, 2.5}, {0.4, 1, 0.8}, 11.530427938270273 / 2},
        {{1, 2, 2.5}, {0.1, 2, 0.3}, 13.385002574472468 / 2},
        {{1, 2, 2.5}, {2, 0.3, -0.5}, 5.830984475698315 / 2},
        {{2.5, 1, 2}, {1, -2, 0.5}, 6.218255941931519 / 2}})
    expect("interval [s] " + of_body(I, omega), flip_interval(I, omega), interval,
           32 * 30 * k_u * interval);
}

TEST_CASE("the interval from a small wobble") {
  // As above: 1 - kappa² is 6 eps²/100 with the wobble eps, and K grows as half the
  // logarithm of one over it
  struct Row {
    Real eps, interval;
  };
  for (const auto& [eps, interval] : {Row{0.1, 4.557080307807958},
                                      {0.01, 6.617115743088258},
                                      {0.001, 8.676618927137815}}) {
    const Vec3 omega{eps, 5, 0};
    const Real difference = 0.06 * eps * eps;
    expect("interval [s] " + of_body({1, 2, 2.5}, omega),
           flip_interval({1, 2, 2.5}, omega), interval, 32 * k_u / difference);
  }
}

TEST_CASE("the interval from a tiny wobble, to the last digits") {
  expect("interval [s] " + of_body({1, 2, 2.5}, {1e-5, 5, 0}),
         flip_interval({1, 2, 2.5}, {1e-5, 5, 0}), 12.795608477382727,
         32 * k_u * 12.795608477382727);
}

TEST_CASE("without a wobble it never flips") {
  expect("one over the interval [1/s] " + of_body({1, 2, 2.5}, {0, 5, 0}),
         1 / flip_interval({1, 2, 2.5}, {0, 5, 0}), 0, 0);
}
