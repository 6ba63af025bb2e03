// A single step must solve its equation (2.11), for any drag; many steps must approach
// the exact flight with the square of dt, and must not gain speed from drag alone.
#include "chapters/02-verlet/exercises/2_4_drag.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "common/physics/exact.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
const exact::Motion k_start{{1, 2, 3}, {20, 5, -3}};
const Vec3 k_g{0, -9.81, 0};

Vec3 rate(Real b, Real q, const Vec3& v) {
  return k_g - (b + q * glm::length(v)) * v;
}

// Of (2.11) both sides, each rounded a dozen times to u of its largest term. The drag's
// own kick is the difference of the others.
void expect_solved(Real b, Real q, Real dt) {
  auto [x, v] = k_start;
  fall_step(x, v, k_g, b, q, dt);
  const Vec3 half = k_start.v + dt / 2 * rate(b, q, k_start.v);
  const Vec3 place = k_start.x + dt * half;
  const Vec3 right = half + dt / 2 * rate(b, q, v);
  const Real largest = 2 * (glm::length(half) + dt / 2 * glm::length(k_g));
  for (const int i : {0, 1, 2}) {
    const std::string which = fmt::format(
        "{}, after a step of {} s with b = {}/s, q = {}/m", "xyz"[i], dt, b, q);
    expect("position [m], " + which, x[i], place[i], 16 * k_u * (3 + dt * largest));
    expect("new velocity [m/s] against where its own drag leads, " + which, v[i],
           right[i], 16 * k_u * largest);
  }
}

// The order by which a flight of two seconds approaches the exact one
Real order(Real b, Real q) {
  const exact::Motion right = q > 0 ? exact::quadratic_drag(k_start, k_g, q, 2)
                                    : exact::linear_drag(k_start, k_g, b, 2);
  const auto error = [&](int steps) {
    auto [x, v] = k_start;
    for (int i = 0; i < steps; ++i) fall_step(x, v, k_g, b, q, Real(2) / steps);
    return glm::length(x - right.x) + glm::length(v - right.v);
  };
  return std::log2(error(400) / error(800));
}

}  // namespace

TEST_CASE("with linear drag the new velocity is where its own drag leads") {
  for (const Real b : {0.0, 0.3, 2.0, 50.0, 1e6}) expect_solved(b, 0, 0.125);
}

TEST_CASE("with linear drag half the step leaves a quarter of the error") {
  // The next term of the series has dt⁴
  for (const Real b : {0.3, 2.0})
    expect(fmt::format("order with b = {}/s", b), order(b, 0), 2, 0.01);
}

TEST_CASE("with quadratic drag the new velocity is where its own drag leads") {
  for (const Real q : {0.05, 2.0, 1e6, 1e-13}) expect_solved(0, q, 0.125);
}

TEST_CASE("with quadratic drag half the step leaves a quarter of the error") {
  for (const Real q : {0.01, 0.2})
    expect(fmt::format("order with q = {}/m", q), order(0, q), 2, 0.01);
}

TEST_CASE("with both drags the new velocity is where they lead") {
  for (const Real q : {0.05, 3.0}) expect_solved(1.5, q, 0.25);
}

TEST_CASE("a ball at rest without gravity stays at rest") {
  Vec3 x{1, 2, 3}, v{0};
  fall_step(x, v, Vec3(0), 1.5, 0.05, 0.1);
  expect("its speed [m/s]", glm::length(v), 0, 0);
}

TEST_CASE("fierce drag explodes nothing") {
  for (const Real strength : {1.0, 1e2, 1e4}) {
    auto [x, v] = k_start;
    for (int i = 1; i <= 200; ++i) {
      const Real before = glm::length(v);
      fall_step(x, v, Vec3(0), strength, strength, 0.1);

      // Without gravity drag can only take speed, but for a dozen roundings
      const Real gained = glm::length(v) - before;
      const std::string which = fmt::format("step {} of 0.1 s with b = {}/s, q = {}/m",
                                            i, strength, strength);
      expect("speed [m/s] that drag adds in " + which, std::max(gained, 0.0), 0,
             16 * k_u * before);
    }
  }
}
