// The two limits that the chapter gives, and beyond them the engine itself: just below
// the limit the state must stay small, just above it must grow.
#include "chapters/01-particles/exercises/1_5_largest_step.hpp"

#include <cmath>

#include "common/physics/euler.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_rounding = 1e-14;  // of a handful of operations, relative

bool explodes(Real m, Real k, Real c, Real dt) {
  const Acceleration damped_spring = [=](auto x, auto v, Real, auto a) {
    a[0] = -(k * x[0] + c * v[0]) / m;
  };
  State state{.x = {1}, .v = {0}, .a = {0}};
  for (int i = 0; i < 3000; ++i) {
    semi_implicit_euler(state, damped_spring, 0, dt);
    if (!(std::abs(state.x[0]) < 1e6)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a spring alone has the limit (1.20)") {
  for (const Real k : {0.01, 1.0, 14'400.0})
    expect(fmt::format("largest step [s] for m = 4 kg, k = {} N/m, c = 0", k),
           largest_step(4, k, 0), 4 / std::sqrt(k), k_rounding * 4 / std::sqrt(k));
}

TEST_CASE("drag alone has the limit c dt / m = 2") {
  for (const Real c : {0.01, 1.0, 500.0})
    expect(fmt::format("largest step [s] for m = 4 kg, k = 0, c = {} kg/s", c),
           largest_step(4, 0, c), 8 / c, k_rounding * 8 / c);
}

TEST_CASE("with both, the engine is stable just below the limit and not above") {
  for (const Real c : {0.1, 2.0, 40.0, 300.0}) {
    const Real m = 0.5, k = 200, dt = largest_step(m, k, c);
    const std::string what = fmt::format(
        "your limit of {:.6g} s for m = {} kg, k = {} N/m, c = {} kg/s", dt, m, k, c);
    if (explodes(m, k, c, 0.99 * dt))
      FAIL(what << " is too large: 1 % below it the motion explodes");
    if (!explodes(m, k, c, 1.01 * dt))
      FAIL(what << " is too small: 1 % above it the motion is still stable");
  }
}

TEST_CASE("in overwhelming drag no digits are lost") {
  // The spring's share of the limit is k m/c² = 1e-20 of it
  expect("largest step [s] for m = 1 kg, k = 1 N/m, c = 1e10 kg/s",
         largest_step(1, 1, 1e10), 2e-10, k_rounding * 2e-10);
}
