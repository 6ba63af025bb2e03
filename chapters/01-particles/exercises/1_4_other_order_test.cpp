// The method by single steps that are exact in binary; the kept quantity over a
// thousand steps of the test's own, so that each half of the exercise can be solved
// alone.
#include "chapters/01-particles/exercises/1_4_other_order.hpp"

#include <limits>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
constexpr Real k_mass = 3, k_stiffness = 12;  // omega = 2 per second

State step_from(Real x, Real v, const Acceleration& acceleration, Real t, Real dt) {
  State state{.x = {x}, .v = {v}, .a = {0}};
  drift_kick(state, acceleration, t, dt);
  return state;
}

}  // namespace

TEST_CASE("the old velocity moves the position, then the new position the velocity") {
  const Acceleration spring = [](auto x, auto, Real, auto a) { a[0] = -x[0]; };
  const State end = step_from(1, 1, spring, 0, 0.5);
  expect("position [m] after a step of 0.5 s from x = 1, v = 1 with a = -x", end.x[0],
         1.5, 0);
  expect("velocity [m/s] after a step of 0.5 s from x = 1, v = 1 with a = -x", end.v[0],
         0.25, 0);
}

TEST_CASE("the acceleration is asked for at the end of the step, once") {
  int asked = 0;
  const Acceleration rising = [&](auto, auto, Real t, auto a) {
    a[0] = t;
    ++asked;
  };
  const State end = step_from(0, 0, rising, 1, 0.5);
  expect("accelerations asked for in a step", asked, 1, 0);
  expect("velocity [m/s] after a step from t = 1 s to 1.5 s with a = t", end.v[0], 0.75,
         0);
}

TEST_CASE("without a step the kept quantity is the energy") {
  for (const Real x : {0.5, -1.0})
    expect(fmt::format("kept quantity [J] at dt = 0, m = 3, k = 12, x = {}, v = 2", x),
           kept_quantity(k_mass, k_stiffness, x, 2, 0), 6 + 6 * x * x, 16 * k_u * 12);
}

TEST_CASE("the kept quantity stays as it is for a thousand steps") {
  for (const Real dt : {0.01, 0.1, 0.5, 0.9}) {
    Real x = 1, v = 0.5;
    const Real start = kept_quantity(k_mass, k_stiffness, x, v, dt);
    for (int i = 1; i <= 1000; ++i) {
      x += v * dt;
      v -= k_stiffness / k_mass * x * dt;

      // A step rounds x and v by 2 u of their size, in energy at most 1/(1 - z/2) of it
      expect(fmt::format("kept quantity [J] after {} steps of {} s", i, dt),
             kept_quantity(k_mass, k_stiffness, x, v, dt), start,
             i * 8 * k_u / (1 - dt) * start);
    }
  }
}
