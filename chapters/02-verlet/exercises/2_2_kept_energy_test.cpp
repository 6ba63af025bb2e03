// Over many steps of the engine's velocity Verlet. On a spring the quantity may change
// by rounding alone; on a pendulum by what shrinks with the fourth power of dt.
#include "chapters/02-verlet/exercises/2_2_kept_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/physics/exact.hpp"
#include "common/physics/systems.hpp"
#include "common/physics/verlet.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
constexpr Real k_mass = 3, k_stiffness = 12;  // omega = 2 per second
constexpr Real k_omega0 = 3;

const Acceleration k_spring = [](auto x, auto, Real, auto a) {
  a[0] = -k_stiffness / k_mass * x[0];
};
const Acceleration k_pendulum = [](auto x, auto, Real, auto a) {
  a[0] = pendulum(k_omega0 * k_omega0, 1, x[0]);
};

State begin_verlet(const exact::Coordinate& start, const Acceleration& acceleration) {
  State state{.x = {start.x}, .v = {start.v}, .a = {0}};
  evaluate(state, {}, acceleration, 0, 0);
  return state;
}

// How far apart the kept quantity's largest and smallest value are within ten seconds
Real change(const exact::Coordinate& start, int steps) {
  State state = begin_verlet(start, k_pendulum);
  const Real dt = Real(10) / steps;
  Real least = std::numeric_limits<Real>::infinity();
  Real most = -least;
  for (int i = 0; i < steps; ++i) {
    velocity_verlet(state, k_pendulum, i * dt, dt);
    const Real kept = kept_on_pendulum(k_omega0, state.x[0], state.v[0], dt);
    least = std::min(least, kept);
    most = std::max(most, kept);
  }
  return most - least;
}

}  // namespace

TEST_CASE("on a spring, without a step, it is the energy") {
  for (const Real x : {0.5, -1.0})
    expect(fmt::format("kept [J] at dt = 0, m = 3, k = 12, x = {}, v = 2", x),
           kept_on_spring(k_mass, k_stiffness, x, 2, 0), 6 + 6 * x * x, 16 * k_u * 12);
}

TEST_CASE("on a spring it stays as it is for a thousand steps") {
  for (const Real z : {0.01, 0.5, 1.0, 1.9, 1.99}) {
    State state = begin_verlet({1, 0.5}, k_spring);
    const Real dt = z / 2;
    const Real start = kept_on_spring(k_mass, k_stiffness, 1, 0.5, dt);
    for (int i = 1; i <= 1000; ++i) {
      velocity_verlet(state, k_spring, 0, dt);

      // A step rounds x and v a few times, to u of their size, and the half-step
      // velocity, whose energy is up to 1/(1 - z²/4) times what is kept
      expect(fmt::format("kept [J] at the end of step {} at omega dt = {}", i, z),
             kept_on_spring(k_mass, k_stiffness, state.x[0], state.v[0], dt), start,
             i * 16 * k_u / (1 - z * z / 4) * start);
    }
  }
}

TEST_CASE("on a pendulum, without a step, it is the energy") {
  for (const Real theta : {0.5, 3.0})
    expect(
        fmt::format("kept [1/s²] at dt = 0, omega0 = 3, theta = {}, omega = 2", theta),
        kept_on_pendulum(k_omega0, theta, 2, 0), 2 - 9 * std::cos(theta),
        16 * k_u * 11);
}

TEST_CASE("on a pendulum half the step leaves a sixteenth of the change") {
  // From turning over to a small swing. The next term of the series has dt⁶: at 600
  // steps, omega0 dt = 1/20, it is a few thousandths of this one.
  for (const exact::Coordinate& start :
       {exact::Coordinate{0, 7}, {2.5, 0}, {1, 0.5}, {0.1, 0}}) {
    const Real coarse = change(start, 600);
    const Real order = std::log2(coarse / change(start, 1200));
    expect(fmt::format("order in dt of the change of what is kept (from theta = {}, "
                       "omega = {}: by {:.3g} 1/s² at dt = 1/60 s)",
                       start.x, start.v, coarse),
           std::min(order, 4.0), 4, 0.05);
  }
}
