// Against the exact flight (1.15) and against itself in smaller steps. A step rounds a
// few times, to u of the largest velocity in it.
#include "chapters/01-particles/exercises/1_2_fall.hpp"

#include <cmath>
#include <limits>

#include "common/physics/exact.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
const Vec3 k_v{20, 5, -3};
const Vec3 k_g{0, -9.81, 0};

void expect_vector(const std::string& what, const Vec3& yours, const Vec3& right,
                   double tolerance) {
  for (const int i : {0, 1, 2})
    expect(fmt::format("{}, {} [m/s]", what, "xyz"[i]), yours[i], right[i], tolerance);
}

}  // namespace

TEST_CASE("without gravity the share that is left is a power of e") {
  for (const Real b : {0.5, 1.5, 2.5, 100.0})
    expect_vector(fmt::format("no gravity, b = {}/s, a step of 1 s", b),
                  fall_velocity(k_v, Vec3(0), b, 1), std::exp(-b) * k_v, 8 * k_u * 20);
}

TEST_CASE("with gravity and drag the velocity is the exact one") {
  for (const Real b : {0.1, 2.5, 40.0}) {
    const Vec3 right = exact::linear_drag({{}, k_v}, k_g, b, 2).v;
    expect_vector(fmt::format("with gravity, b = {}/s, a step of 2 s", b),
                  fall_velocity(k_v, k_g, b, 2), right, 8 * k_u * 40);
  }
}

TEST_CASE("sixty small steps end where a large one does") {
  Vec3 v = k_v;
  for (int i = 0; i < 60; ++i) v = fall_velocity(v, k_g, 3, 1.0 / 60);
  expect_vector("60 steps of 1/60 s, b = 3/s", v,
                exact::linear_drag({{}, k_v}, k_g, 3, 1).v, 60 * 8 * k_u * 30);
}

TEST_CASE("without drag it is free fall") {
  expect_vector("b = 0, a step of 0.5 s", fall_velocity(k_v, k_g, 0, 0.5),
                k_v + 0.5 * k_g, 8 * k_u * 30);
}

TEST_CASE("with hardly any drag no digits are lost") {
  const Vec3 right = exact::linear_drag({{}, k_v}, k_g, 1e-12, 0.5).v;
  expect_vector("to the last digit, b = 1e-12/s, a step of 0.5 s",
                fall_velocity(k_v, k_g, 1e-12, 0.5), right, 8 * k_u * 30);
}
