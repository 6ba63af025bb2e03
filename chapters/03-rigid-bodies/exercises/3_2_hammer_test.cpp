// Bodies whose moments are known in another way: a box from two parts of itself, a
// square ring as a box with a hole, a dumbbell, and a hammer.
#include "chapters/03-rigid-bodies/exercises/3_2_hammer.hpp"

#include <limits>
#include <string>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

// Of 1 kg a m³; negative if it is a hole
Spread box(const Vec3& centre, const Vec3& size, Real density = 1) {
  const Real mass = density * size.x * size.y * size.z;
  const Vec3 s2 = size * size;
  return {mass, centre, mass / 12 * Vec3(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y)};
}

// A dozen roundings to u of the largest number, at places not further away than `reach`
void expect_spread(const std::string& what, const Spread& yours, const Spread& right,
                   Real reach) {
  expect("mass [kg] of " + what, yours.mass, right.mass, 16 * k_u * right.mass);
  expect("centre [m] of " + what, yours.centre, right.centre, 16 * k_u * reach);
  expect("moments [kg m²] of " + what, yours.moments, right.moments,
         16 * k_u * right.mass * reach * reach);
}

}  // namespace

TEST_CASE("about another point there is more to turn") {
  const Spread rod{3, {0, 0, 1}, {1, 1, 0}};  // 2 m along z
  expect("moments [kg m²] of a rod of 3 kg and 2 m along z about its end",
         moments_about(rod, {0, 0, 0}), {4, 4, 0}, 0);
  const Spread ball{2, {1, 2, 3}, {0.25, 0.25, 0.25}};
  expect("moments [kg m²] of a ball of 2 kg at (1, 2, 3) m about (0, 0, 1) m",
         moments_about(ball, {0, 0, 1}), {16.25, 10.25, 10.25}, 0);
}

TEST_CASE("a box cut in two and joined again is the box") {
  const Vec3 size{1, 2, 4}, centre{3, -1, 2};
  for (const int axis : {0, 1, 2}) {
    for (const Real share : {0.5, 0.3}) {
      // Each part's own size, and its centre in the middle of it
      Vec3 low_size = size, high_size = size, low = centre, high = centre;
      low_size[axis] *= share;
      high_size[axis] *= 1 - share;
      low[axis] -= (size[axis] - low_size[axis]) / 2;
      high[axis] += (size[axis] - high_size[axis]) / 2;
      expect_spread(fmt::format("a box of 1 m x 2 m x 4 m, cut across {} at {}",
                                "xyz"[axis], share),
                    joined(box(low, low_size), box(high, high_size)), box(centre, size),
                    6);
    }
  }
}

TEST_CASE("a hole is a part with less than no mass") {
  expect_spread("a box of 4 m x 4 m x 1 m without 2 m x 2 m x 1 m in its middle",
                joined(box(Vec3(0), {4, 4, 1}), box(Vec3(0), {2, 2, 1}, -1)),
                {12, {0, 0, 0}, {21, 21, 40}}, 4);

  // What is left of a box without its end is a shorter box
  expect_spread("a box of 5 m x 1 m x 1 m, its end at x from 2 m to 5 m cut off",
                joined(box({2.5, 0, 0}, {5, 1, 1}), box({3.5, 0, 0}, {3, 1, 1}, -1)),
                box({1, 0, 0}, {2, 1, 1}), 8);
}

TEST_CASE("a dumbbell from two balls and a rod") {
  // The balls are 2 kg and 0.5 m: 2/5 m r² = 0.2 kg m². The rod is 3 kg and 2 m.
  const Spread above{2, {0, 0, 1}, Vec3(0.2)}, below{2, {0, 0, -1}, Vec3(0.2)};
  const Spread rod{3, {0, 0, 0}, {1, 1, 0}};
  expect_spread("a dumbbell", joined(joined(above, rod), below),
                {7, {0, 0, 0}, {5.4, 5.4, 0.4}}, 2);
}

TEST_CASE("a hammer turns about a point near its head") {
  // Handle of 1/4 kg and 1/2 m, head of 3/4 kg. Two bodies d = 1/4 m apart add up to
  // m1 m2 / (m1 + m2) d² more than their own moments.
  const Spread yours = hammer(0.25, 0.5, 0.75, {0.125, 0.0625, 0.03125});
  const Real apart = 0.25 * 0.75 * 0.25 * 0.25;
  const Real handle = 0.25 * 0.5 * 0.5 / 12;
  const Vec3 head = box(Vec3(0), {0.125, 0.0625, 0.03125}, 3072).moments;
  expect_spread("a hammer", yours,
                {1, {0, 0, 0.4375}, head + (apart + handle) * Vec3(1, 1, 0)}, 0.5);
}
