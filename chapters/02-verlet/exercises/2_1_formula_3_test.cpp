// Single steps that are exact in binary, then the engine's kick, drift, kick, with
// which Formula 3 agrees but for rounding.
#include "chapters/02-verlet/exercises/2_1_formula_3.hpp"

#include <limits>
#include <string>

#include "common/physics/verlet.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

}  // namespace

TEST_CASE("the position moves with the old acceleration, the velocity with the mean") {
  const Acceleration spring = [](auto x, auto, Real, auto a) { a[0] = -x[0]; };
  State state{.x = {1}, .v = {1}, .a = {-1}};
  formula_3(state, spring, 0, 0.5);
  const std::string after = "after a step of 0.5 s from x = 1, v = 1 with a = -x";
  expect("position [m] " + after, state.x[0], 1.375, 0);
  expect("velocity [m/s] " + after, state.v[0], 0.40625, 0);
  expect("acceleration left [m/s²] " + after, state.a[0], -1.375, 0);
}

TEST_CASE("the acceleration is asked for once, at the end of the step") {
  int asked = 0;
  const Acceleration rising = [&](auto, auto, Real t, auto a) {
    a[0] = t;
    ++asked;
  };
  State state{.x = {0}, .v = {0}, .a = {1}};
  formula_3(state, rising, 1, 0.5);
  expect("accelerations asked for in a step", asked, 1, 0);
  expect("velocity [m/s] after a step from t = 1 s to 1.5 s with a = t", state.v[0],
         0.625, 0);
}

TEST_CASE("it goes where the engine's kick, drift, kick goes") {
  const Acceleration springs = [](auto x, auto, Real t, auto a) {
    a[0] = -x[0];
    a[1] = t - 4 * x[1];
  };
  State yours{.x = {1, -0.5}, .v = {0.5, 1}, .a = {-1, 2}};
  State right = yours;
  const Real dt = 0.1;
  for (int i = 1; i <= 1000; ++i) {
    const Real t = (i - 1) * dt;
    formula_3(yours, springs, t, dt);
    velocity_verlet(right, springs, t, dt);

    // A step of each rounds five times, to u of at most 25 m; springs let it add up,
    // but not grow
    for (const std::size_t j : {0U, 1U}) {
      const double tolerance = i * 10 * k_u * 25;
      expect(fmt::format("coordinate {} [m] at the end of step {} of 0.1 s", j, i),
             yours.x[j], right.x[j], tolerance);
      expect(fmt::format("its rate [m/s] at the end of step {} of 0.1 s", i),
             yours.v[j], right.v[j], tolerance);
    }
  }
}
