// Throws the ball with the engine's own explicit Euler. All numbers are short in
// binary, so that the flight has no rounding: the tolerance is for the reader's formula
// alone.
#include "chapters/01-particles/exercises/1_1_landing.hpp"

#include <array>

#include "common/physics/euler.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

struct Throw {
  Real speed, g, dt;
};

constexpr std::array<Throw, 4> k_throws{
    {{5, 10, 0.015625}, {20, 10, 0.125}, {3, 1.5, 0.5}, {10, 1.25, 0.0078125}}};
constexpr double k_rounding = 1e-14;  // of a handful of operations, relative

Landing thrown(const Throw& ball) {
  const Acceleration gravity = [&](auto, auto, Real, auto a) { a[0] = -ball.g; };
  State state{.x = {0}, .v = {ball.speed}, .a = {0}};
  explicit_euler(state, gravity, 0, ball.dt);
  int steps = 1;
  for (; state.x[0] > 0; ++steps)
    explicit_euler(state, gravity, steps * ball.dt, ball.dt);
  return {.time = steps * ball.dt, .speed = -state.v[0]};
}

void compare(std::string_view what, const Throw& ball, Real Landing::*quantity) {
  const auto [speed, g, dt] = ball;
  const Real right = thrown(ball).*quantity;
  expect(fmt::format("{} of a throw at {} m/s, g = {} m/s², dt = {} s", what, speed, g,
                     dt),
         explicit_euler_landing(speed, g, dt).*quantity, right, k_rounding * right);
}

}  // namespace

TEST_CASE("the time of explicit Euler's landing") {
  for (const Throw& ball : k_throws) compare("landing time [s]", ball, &Landing::time);
}

TEST_CASE("the speed of explicit Euler's landing") {
  for (const Throw& ball : k_throws)
    compare("landing speed [m/s]", ball, &Landing::speed);
}
