// Chapter 1: what each Euler method does, locked to closed forms. Compiled for each
// precision; u (k_u) is the unit round-off of the one at hand, every tolerance a count
// of roundings times u times the size of what is rounded.
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/euler.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/rounding.hpp"
#include "tests/catch.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

Acceleration constant(Real a) {
  return [a](auto, auto, Real, auto out) { out[0] = a; };
}

Acceleration spring_of(Real k) {
  return [k](auto x, auto, Real, auto out) { out[0] = -k * x[0]; };
}

Acceleration drag_of(Real rate) {
  return [rate](auto, auto v, Real, auto out) { out[0] = -rate * v[0]; };
}

State one(double x, double v) {
  return {.x = {Real(x)}, .v = {Real(v)}, .a = {Real(0)}};
}

State run(Integrator step, State state, const Acceleration& acceleration, double dt,
          int n) {
  for (int i = 0; i < n; ++i) step(state, acceleration, Real(i * dt), Real(dt));
  return state;
}

// The factor by which a halved step divides the error, as a power of two.
double order(double error, double error_of_half_step) {
  return std::log2(error / error_of_half_step);
}

}  // namespace

TEST_CASE("under constant acceleration Euler is off by a t dt / 2, to either side") {
  // 120 steps at 60 Hz: the numbers that the chapter quotes, 0.1635 m
  constexpr double a = -9.81, dt = 1.0 / 60, t = 2;
  constexpr int n = 120;
  const double exact_x =
      exact::constant_acceleration({{}, {20, 0, 0}}, {a, 0, 0}, t).x.x;

  // n roundings of v (at most 20 m/s), carried for t; n roundings of x (at most 21 m)
  const double tolerance = k_u * (n + 4) * (20 * t + 21);
  const auto error = [&](Integrator step) {
    return run(step, one(0, 20), constant(Real(a)), dt, n).x[0] - exact_x;
  };
  CHECK(error(explicit_euler) == Approx(-a * t * dt / 2).margin(tolerance));
  CHECK(error(semi_implicit_euler) == Approx(a * t * dt / 2).margin(tolerance));
  CHECK(error(modified_euler) == Approx(0).margin(tolerance));
}

TEST_CASE("under constant acceleration every method's velocity is exact") {
  for (const NamedIntegrator& method : euler_methods()) {
    const State end =
        run(method.step, one(0, 20), constant(Real(-9.81)), 1.0 / 60, 120);
    CHECK(end.v[0] == Approx(20 - 9.81 * 2).margin(k_u * 124 * 20));
  }
}

TEST_CASE("with constant velocity all three methods agree and are exact") {
  // The thesis: "Euler would be more stable with constant velocities": no method
  // differs
  for (const NamedIntegrator& method : euler_methods()) {
    const State end = run(method.step, one(0, 0.75), constant(0), 0.125, 1000);
    CHECK(end.x[0] == Real(93.75));
  }
}

TEST_CASE("explicit Euler multiplies a spring's energy by 1 + z² in every step") {
  for (const double z : {0.01, 0.1, 0.5, 1.0, 2.5}) {
    constexpr int n = 40;  // more would leave the range of float at z = 2.5
    const State end = run(explicit_euler, one(1, 0), spring_of(1), z, n);
    const double ratio = double(end.x[0]) * end.x[0] + double(end.v[0]) * end.v[0];

    // Each step rounds x and v by up to 2 u of their size: 4 u of the energy; z is off
    // by u
    CHECK(ratio / std::pow(1 + z * z, n) == Approx(1).margin(n * 8 * k_u));
  }
}

TEST_CASE("modified Euler's area factor is 1 + z²/2: half of explicit Euler's growth") {
  for (const double z : {0.01, 0.1, 0.5, 1.0, 2.5}) {
    const State x = run(modified_euler, one(1, 0), spring_of(1), z, 1);
    const State v = run(modified_euler, one(0, 1), spring_of(1), z, 1);
    const double determinant = double(x.x[0]) * v.v[0] - double(v.x[0]) * x.v[0];
    CHECK(determinant == Approx(1 + z * z / 2).margin(8 * k_u * (1 + z * z)));
  }
}

TEST_CASE("semi-implicit Euler keeps x² + v² - z x v on a spring") {
  for (const double z : {0.01, 0.1, 0.5, 1.0, 1.9, 1.99}) {
    State state = one(1, 0);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
      semi_implicit_euler(state, spring_of(1), 0, Real(z));
      const double x = state.x[0], v = state.v[0], h = Real(z);
      worst = std::max(worst, std::abs(x * x + v * v - h * x * v - 1));
    }

    // A step rounds x and v by 2 u of their size, at most 1/(1 - z/2) in energy
    CHECK(worst <= 1000 * 8 * k_u / (1 - z / 2));
  }
}

TEST_CASE("semi-implicit Euler is stable just below omega dt = 2 and not above") {
  const auto largest = [](double z) {
    State state = one(1, 0);
    double most = 0;
    for (int i = 0; i < 2000; ++i) {
      semi_implicit_euler(state, spring_of(1), 0, Real(z));
      most = std::max(most, std::abs(double(state.x[0])));
    }
    return most;
  };

  // x² <= 1 / (1 - z²/4) on the invariant ellipse
  CHECK(largest(1.999) <= 1.01 / std::sqrt(1 - 1.999 * 1.999 / 4));
  CHECK(largest(2.001) > 1e10);
}

TEST_CASE("halving the step halves the error of all three on a spring") {
  for (const NamedIntegrator& method : euler_methods()) {
    const auto error = [&](int n) {
      const State end = run(method.step, one(1, 0), spring_of(1), 2.0 / n, n);
      return std::hypot(end.x[0] - std::cos(2.0), end.v[0] + std::sin(2.0));
    };
    CHECK(order(error(200), error(400)) == Approx(1).margin(0.05));
  }
}

TEST_CASE("explicit drag decays, swings or explodes as c dt / m passes 1 and 2") {
  const auto end = [](double rate_dt) {
    return double(run(explicit_euler, one(0, 1), drag_of(1), rate_dt, 10).v[0]);
  };
  CHECK(end(0.5) == Approx(std::pow(0.5, 10)).epsilon(20 * k_u));
  CHECK(end(1.9) == Approx(std::pow(-0.9, 10)).epsilon(200 * k_u));
  CHECK(end(2.5) == Approx(57.6650390625).epsilon(200 * k_u));
}

TEST_CASE("damping does not depend on the step, and never overshoots") {
  // Sixty steps of 1/60 s or one of 1 s: the same share is left
  const auto left = [](int n) {
    Real v = 1;
    for (int i = 0; i < n; ++i) v *= damping_factor(Real(0.3), Real(1) / Real(n));
    return v;
  };
  CHECK(left(60) == Approx(0.3).epsilon(60 * 4 * k_u));
  CHECK(left(1) == Approx(0.3).epsilon(4 * k_u));
  CHECK(damping_factor(Real(1e-6), 1) > 0);
  CHECK(damping_factor(1, Real(0.25)) == 1);
}

TEST_CASE("forces: weight, spring and drag point the right way") {
  const Vec3 v{3, 4, 0};
  CHECK(weight(2, {0, -10, 0}) == Vec3(0, -20, 0));
  CHECK(spring(10, {1, 0, 0}, {3, 0, 0}) == Vec3(20, 0, 0));
  CHECK(linear_drag(2, v) == Vec3(-6, -8, 0));
  CHECK(quadratic_drag(2, v) == Vec3(-30, -40, 0));
  CHECK(newton({6, 0, 0}, Real(0.5)) == Vec3(3, 0, 0));
  CHECK(newton({6, 0, 0}, 0) == Vec3(0));
}

TEST_CASE("exact linear drag passes into free flight as the drag goes to zero") {
  const exact::Motion start{{1, 2, 3}, {10, 20, -5}};
  const glm::dvec3 g{0, -9.81, 0};
  const exact::Motion free = exact::constant_acceleration(start, g, 3);
  for (const double b : {0.0, 1e-300, 1e-16, 1e-9}) {
    // The first neglected term is b t² / 2 times the velocity
    const exact::Motion dragged = exact::linear_drag(start, g, b, 3);
    CHECK(glm::distance(dragged.x, free.x) <= 1e-13 + b * 4.5 * 40);
  }

  // Either side of the switch between series and closed form
  const exact::Motion below = exact::linear_drag(start, g, std::nextafter(0.5, 0.0), 1);
  const exact::Motion above = exact::linear_drag(start, g, std::nextafter(0.5, 1.0), 1);
  CHECK(glm::distance(below.x, above.x) <= 1e-14 * 30);
}

TEST_CASE("exact quadratic drag satisfies its own differential equation") {
  // Two-sided difference of the exact velocity against g - k |v| v; error h² v''' / 6 +
  // u v / h
  const glm::dvec3 g{0, -9.81, 0};
  constexpr double k = 0.05, h = 1e-4;
  const exact::Motion start{{0, 1, 0}, {20, 25, -5}};
  for (const double t : {0.1, 0.7, 2.0, 10.0}) {
    const glm::dvec3 v = exact::quadratic_drag(start, g, k, t).v;
    const glm::dvec3 ahead = exact::quadratic_drag(start, g, k, t + h).v;
    const glm::dvec3 behind = exact::quadratic_drag(start, g, k, t - h).v;
    const glm::dvec3 a = g - k * glm::length(v) * v;
    CHECK(glm::distance((ahead - behind) / (2 * h), a) <= 1e-6);
  }
}

TEST_CASE("exact quadratic drag agrees with an independent integration") {
  // Classical Runge-Kutta in 20,000 steps, written here: its error, of the fourth power
  // of the step, and the rounding of 20,000 additions to 25 m both stay below 1e-10
  const glm::dvec3 g{0, -9.81, 0};
  constexpr int n = 20'000;
  constexpr double k = 0.05, h = 3.0 / n;
  const auto a = [&](const glm::dvec3& w) { return g - k * glm::length(w) * w; };
  glm::dvec3 x{0, 1, 0}, v{20, 25, -5};
  for (int i = 0; i < n; ++i) {
    const glm::dvec3 a1 = a(v);
    const glm::dvec3 v2 = v + h / 2 * a1, a2 = a(v2);
    const glm::dvec3 v3 = v + h / 2 * a2, a3 = a(v3);
    const glm::dvec3 v4 = v + h * a3, a4 = a(v4);
    x += h / 6 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  const auto end = exact::quadratic_drag({{0, 1, 0}, {20, 25, -5}}, g, k, 3);
  CHECK(glm::distance(x, end.x) <= 1e-10);
  CHECK(glm::distance(v, end.v) <= 1e-10);
}

TEST_CASE("exact quadratic drag: position is the integral of velocity") {
  // Simpson's rule over 8,000 pieces: its error falls with the fourth power, to 1e-12
  const exact::Motion start{{0, 1, 0}, {20, 25, -5}};
  const glm::dvec3 g{0, -9.81, 0};
  constexpr int n = 8000;
  constexpr double t = 3, h = t / n;
  glm::dvec3 sum = start.v;
  for (int i = 1; i <= n; ++i) {
    const double weight = i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * exact::quadratic_drag(start, g, 0.05, i * h).v;
  }
  const glm::dvec3 x = start.x + h / 3 * sum;
  CHECK(glm::distance(x, exact::quadratic_drag(start, g, 0.05, t).x) <= 1e-11);
}

TEST_CASE("exact quadratic drag: a nearly vertical throw is the vertical one") {
  const glm::dvec3 g{0, -9.81, 0};
  for (const double up : {30.0, 0.0, -30.0, -80.0}) {
    const auto straight = exact::quadratic_drag({{}, {0, up, 0}}, g, 0.02, 4);
    const auto tilted = exact::quadratic_drag({{}, {1e-9, up, 0}}, g, 0.02, 4);
    CHECK(glm::distance(straight.x, tilted.x) <= 1e-8);
    CHECK(glm::distance(straight.v, tilted.v) <= 1e-8);
  }
}

TEST_CASE("exact oscillator is continuous through critical damping") {
  const auto at_gamma = [](double gamma) {
    return exact::oscillator({1, 2}, 3, gamma, 1.5);
  };
  const exact::Coordinate critical = at_gamma(3);
  for (const double gamma : {3 - 1e-7, 3 + 1e-7}) {
    CHECK(at_gamma(gamma).x == Approx(critical.x).margin(1e-6));
    CHECK(at_gamma(gamma).v == Approx(critical.v).margin(1e-6));
  }

  // Heavily overdamped, where cosh would overflow
  const exact::Coordinate heavy = exact::oscillator({1, 0}, 1, 1e6, 10);
  CHECK(heavy.x == Approx(std::exp(-0.5e-6 * 10)).epsilon(1e-9));
}

TEST_CASE("in quadratic drag the methods converge to the exact flight with order 1") {
  const glm::dvec3 g{0, -9.81, 0};
  const exact::Motion start{{0, 1, 0}, {20, 25, -5}};
  const Acceleration flight = [&](auto, auto v, Real, auto a) {
    put(a, 0, weight(1, Vec3(g)) + quadratic_drag(Real(0.05), at(v, 0)));
  };
  const glm::dvec3 end = exact::quadratic_drag(start, g, 0.05, 2).x;
  for (const NamedIntegrator& method : euler_methods()) {
    const auto error = [&](int n) {
      State state = particles(1);
      put(state.x, 0, Vec3(start.x));
      put(state.v, 0, Vec3(start.v));
      return glm::distance(
          glm::dvec3(at(run(method.step, state, flight, 2.0 / n, n).x, 0)), end);
    };
    CHECK(order(error(400), error(800)) == Approx(1).margin(0.1));
  }
}

TEST_CASE("an hour of 1/60 s steps: what the clock shows") {
  const double t = accumulated_time(Real(1.0 / 60), 216'000);
  if (k_single)
    CHECK(t == 3597.206787109375);
  else
    CHECK(t == 3600.0000000182276);
}

TEST_CASE("spacing of the numbers at a million metres") {
  CHECK(spacing(Real(1e6)) == (k_single ? 0.0625 : 1.1641532182693481e-10));
  CHECK(spacing(Real(-1e6)) == spacing(Real(1e6)));
  CHECK(spacing(0) == std::numeric_limits<Real>::denorm_min());
}

TEST_CASE("an integrator runs through many particles as through one") {
  State many = particles(1000);
  for (std::size_t i = 0; i < 1000; ++i) put(many.v, i, {Real(i), 1, -Real(i)});
  const Acceleration gravity = [](auto, auto v, Real, auto a) {
    for (std::size_t i = 0; i < v.size() / 3; ++i) put(a, i, {0, -10, 0});
  };
  for (const NamedIntegrator& method : euler_methods()) {
    const State end = run(method.step, many, gravity, 0.125, 8);
    State single = particles(1);
    put(single.v, 0, at(many.v, 77));
    const State alone = run(method.step, single, gravity, 0.125, 8);
    CHECK(at(end.x, 77) == at(alone.x, 0));
    CHECK(at(end.v, 77) == at(alone.v, 0));
  }
}
