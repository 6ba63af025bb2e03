// Errors that are exact powers, then those of a real method, then ones that lie.
#include "chapters/07-trade/exercises/7_2_order.hpp"

#include <cmath>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

// Logarithms and powers, each right to a few units in the last place
constexpr Real k_rounding = 1e-13;

// A weight on a spring, x'' = -x, from x = 1 at rest: how far velocity Verlet is from
// cos t after one second [m]
Real error_of_verlet(int steps) {
  const Real dt = Real(1) / steps;
  Real x = 1, v = 0;
  for (int i = 0; i < steps; ++i) {
    const Real half = v - x * dt / 2;
    x += half * dt;
    v = half - x * dt / 2;
  }
  return std::abs(x - std::cos(Real(1)));
}

}  // namespace

TEST_CASE("errors that are exact powers of the step") {
  for (const int order : {1, 2, 4}) {
    const Real constant = 3;
    const auto trial = [&](Real dt) {
      return Trial{dt, constant * std::pow(dt, Real(order))};
    };
    for (const Convergence& c :
         {convergence(trial(0.1), trial(0.05)), convergence(trial(0.01), trial(0.1))}) {
      expect(fmt::format("order of a method of order {}", order), c.order, order,
             k_rounding * 10);
      expect("constant", c.constant, constant, k_rounding * 100);
      expect("step [s] for an error of 3e-8", step_for(c, 3e-8),
             std::pow(Real(1e-8), Real(1) / order), k_rounding);
    }
  }
}

TEST_CASE("velocity Verlet, from 20 and 40 steps") {
  const Convergence c =
      convergence({1.0 / 20, error_of_verlet(20)}, {1.0 / 40, error_of_verlet(40)});
  // What comes after dt² in the error is smaller by dt² again: 1/400, in the order
  // over log 2
  expect("order", c.order, 2, 0.005);

  // A millionth: steps that differ from 1/n by less than a step in n
  const Real dt = step_for(c, 1e-6);
  if (!(dt > 1e-4 && dt < 1)) FAIL(fmt::format("a step of {} s is out of sight", dt));
  const int steps = static_cast<int>(std::lround(1 / dt));
  expect(fmt::format("error [m] with {} steps", steps), error_of_verlet(steps), 1e-6,
         0.02e-6);
}

TEST_CASE("where rounding rules, shorter steps do not help") {
  const Convergence c = convergence({1e-4, 1e-13}, {1e-5, 8e-13});
  expect("order", c.order, std::log10(1.0 / 8), k_rounding * 10);
  expect("step [s]", step_for(c, 1e-14), 0, 0);
  expect("step [s] where nothing changes",
         step_for(convergence({0.1, 1e-3}, {0.05, 1e-3}), 1e-4), 0, 0);
}
