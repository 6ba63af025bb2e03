// First on numbers that are off by exactly C dt^p, then on the engine's methods: on a
// double pendulum, of which no closed form is known, and against exact motions.
#include "chapters/02-verlet/exercises/2_3_richardson.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "common/physics/exact_orbit.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "common/physics/schemes.hpp"
#include "common/physics/systems.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

struct MadeUp {
  Real right, off, p;  // off: C dt^p

  Real at(Real share_of_dt) const { return right + off * std::pow(share_of_dt, p); }
};

constexpr std::array<MadeUp, 5> k_made_up{
    {{3, 1, 1}, {3, -1, 2}, {-5, 0.5, 4}, {0, 1e-9, 3}, {2, 4, 1.5}}};

struct Case {
  std::string_view method;
  Real order;
};

State after(std::string_view method, const Acceleration& acceleration,
            const State& start, Real t, int steps) {
  Integration run = begin(*find_scheme(method), acceleration, start, t / steps);
  for (int i = 0; i < steps; ++i) advance(run);
  return read(run);
}

// The distance of the extrapolated place and velocity from the exact ones
struct Known {
  Acceleration acceleration;
  State start, exact;
  Real t;

  Real error(std::string_view method, int steps) const {
    const State coarse = after(method, acceleration, start, t, steps);
    const State fine = after(method, acceleration, start, t, 2 * steps);
    const Real p = find_scheme(method)->order;
    Real sum = 0;
    for (std::size_t i = 0; i < start.x.size(); ++i) {
      const Real x = extrapolated(coarse.x[i], fine.x[i], p) - exact.x[i];
      const Real v = extrapolated(coarse.v[i], fine.v[i], p) - exact.v[i];
      sum += x * x + v * v;
    }
    return std::sqrt(sum);
  }
};

Known swinging() {
  const exact::Coordinate end = exact::pendulum({1, 0.5}, 1, 3);
  return {
      .acceleration = [](auto x, auto, Real, auto a) { a[0] = pendulum(1, 1, x[0]); },
      .start = {{1}, {0.5}, {0}},
      .exact = {{end.x}, {end.v}, {}},
      .t = 3};
}

Known orbiting() {
  const auto state_at = [](double t) {
    State state = particles(1);
    const exact::Motion motion = exact::orbit(1, 1, 0.5, t);
    put(state.x, 0, motion.x);
    put(state.v, 0, motion.v);
    return state;
  };
  return {
      .acceleration = [](auto x, auto, Real,
                         auto a) { put(a, 0, gravity_towards_origin(1, at(x, 0))); },
      .start = state_at(0),
      .exact = state_at(5),
      .t = 5};
}

}  // namespace

TEST_CASE("the order of numbers that are off by a power of dt") {
  // The differences round by u of the right answer, and so does each of the three
  for (const MadeUp& m : k_made_up) {
    const Real least = std::abs(m.at(0.5) - m.at(0.25));
    expect(fmt::format("order of {} {:+} dt^{}", m.right, m.off, m.p),
           observed_order(m.at(1), m.at(0.5), m.at(0.25)), m.p,
           16 * k_u * (std::abs(m.right) + std::abs(m.off)) / least);
  }
}

TEST_CASE("the order of methods on a double pendulum, which nobody has solved") {
  const Acceleration acceleration = [](auto x, auto v, Real, auto a) {
    double_pendulum({.m1 = 1, .m2 = 0.5, .l1 = 1, .l2 = 0.7, .g = 9.81}, x, v, a);
  };
  const auto angle = [&](std::string_view method, int steps) {
    return after(method, acceleration, {{2, 1}, {0, 0}, {0, 0}}, 1, steps).x[0];
  };

  // Verlet loses an order, since these accelerations depend on the velocities. The next
  // term of the series is smaller by dt times the fastest rate, here about 20/s.
  for (const auto& [method, order] :
       {Case{"velocity_verlet", 1}, {"midpoint", 2}, {"rk4", 4}})
    expect(fmt::format("order of {} on a double pendulum", method),
           observed_order(angle(method, 400), angle(method, 800), angle(method, 1600)),
           order, 0.1);
}

TEST_CASE("the right answer to numbers that are off by a power of dt") {
  for (const MadeUp& m : k_made_up)
    expect(fmt::format("extrapolated {} {:+} dt^{}", m.right, m.off, m.p),
           extrapolated(m.at(1), m.at(0.5), m.p), m.right,
           16 * k_u * (std::abs(m.right) + std::abs(m.off)));
}

TEST_CASE("two results make one of a higher order") {
  // The next term of the series is smaller by dt times the fastest rate of the motion:
  // a sixth, where the orbit is nearest to the centre
  for (const auto& [where, system] :
       {std::pair{"pendulum", swinging()}, std::pair{"orbit", orbiting()}}) {
    for (const auto& [method, order] :
         {Case{"semi_implicit_euler", 2}, {"velocity_verlet", 4}, {"rk4", 5}}) {
      const Real ratio = system.error(method, 100) / system.error(method, 200);
      expect(fmt::format("order of {} on the {}, extrapolated", method, where),
             std::log2(ratio), order, 0.2);
    }
  }
}
