// Chapter 2's systems, its exact motions, constraints of distance, and the step that
// chooses itself. Compiled for each precision; u (k_u) is the unit round-off of the one
// at hand. What is exact is double in both.
#include <array>
#include <cmath>
#include <numbers>

#include "common/physics/distance_constraint.hpp"
#include "common/physics/dormand_prince.hpp"
#include "common/physics/exact_orbit.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "common/physics/particle.hpp"
#include "tests/scheme_run.hpp"

using namespace timestep;

namespace {

constexpr double k_pi = std::numbers::pi;

// Classical Runge-Kutta in double, written here: to check what is exact independently.
// y: coordinates, then rates.
template <std::size_t d, class Force>
std::array<double, 2 * d> runge_kutta(const Force& a, std::array<double, 2 * d> y,
                                      double t, int n) {
  using Y = std::array<double, 2 * d>;
  const auto rate = [&](const Y& at) {
    Y r{};
    const auto acceleration = a(at);
    for (std::size_t i = 0; i < d; ++i) {
      r[i] = at[d + i];
      r[d + i] = acceleration[i];
    }
    return r;
  };
  const auto moved = [](Y at, const Y& by, double h) {
    for (std::size_t i = 0; i < at.size(); ++i) at[i] += h * by[i];
    return at;
  };
  const double h = t / n;
  for (int k = 0; k < n; ++k) {
    const Y k1 = rate(y);
    const Y k2 = rate(moved(y, k1, h / 2));
    const Y k3 = rate(moved(y, k2, h / 2));
    const Y k4 = rate(moved(y, k3, h));
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

State orbit_start(double e) {
  State start = particles(1);
  put(start.x, 0, {Real(1 - e), 0, 0});
  put(start.v, 0, {0, Real(std::sqrt((1 + e) / (1 - e))), 0});
  return start;
}

const Acceleration k_gravity = [](auto x, auto, Real, auto a) {
  put(a, 0, gravity_towards_origin(1, at(x, 0)));
};

constexpr DoublePendulum k_two{1, Real(0.5), Real(1.2), Real(0.7), Real(9.81)};

}  // namespace

TEST_CASE("Kepler's equation is solved for every eccentricity and angle") {
  for (const double e : {0.0, 0.1, 0.5, 0.9, 0.999, 1 - 1e-12}) {
    for (const double M :
         {0.0, 1e-300, 1e-9, 1e-3, 0.5, 3.0, k_pi, -2.0, 6.2, 1000.0}) {
      const double E = exact::eccentric_anomaly(M, e);

      // As an equation for M: E and e sin E round by u of their size each
      INFO("e " << e << " M " << M);
      CHECK(E - e * std::sin(E)
            == Approx(M).margin(4 * 1.1e-16 * (std::abs(M) + std::abs(E))));
      CHECK(exact::eccentric_anomaly(-M, e) == -E);
    }
  }

  // Close to the pericentre E - e sin E is (1 - e) E + E³ / 6
  CHECK(exact::eccentric_anomaly(1e-9, 0.999) == Approx(1e-6).epsilon(1e-9));
}

TEST_CASE("exact orbits agree with an independent integration") {
  const auto gravity = [](const std::array<double, 4>& y) {
    const double r3 = std::pow(std::hypot(y[0], y[1]), 3);
    return std::array{-y[0] / r3, -y[1] / r3};
  };
  for (const double e : {0.0, 0.5, 0.8}) {
    // 40,000 steps over 10 s: of an error of the fourth power of the step there are
    // 1e-10 left at e = 0.8, where a quarter of the period passes in 0.1 s
    const auto y = runge_kutta<2>(gravity, {1 - e, 0, 0, std::sqrt((1 + e) / (1 - e))},
                                  10, 40'000);
    const exact::Motion end = exact::orbit(1, 1, e, 10);
    CHECK(std::hypot(end.x.x - y[0], end.x.y - y[1]) <= 1e-9);
    CHECK(std::hypot(end.v.x - y[2], end.v.y - y[3]) <= 1e-9);
  }
}

TEST_CASE("an orbit's elements come back from every place of it") {
  constexpr double mu = 398600.4418, a = 7000, e = 0.3;
  const double period = 2 * k_pi * std::sqrt(a * a * a / mu);
  for (int i = 0; i < 12; ++i) {
    const exact::Motion now = exact::orbit(mu, a, e, period * (0.3 + i) / 5);
    const exact::OrbitElements kept = exact::elements(mu, now);
    CHECK(kept.energy == Approx(-mu / (2 * a)).epsilon(1e-14));
    CHECK(kept.angular_momentum
          == Approx(std::sqrt(mu * a * (1 - e * e))).epsilon(1e-14));
    CHECK(kept.eccentricity == Approx(e).epsilon(1e-13));
    CHECK(kept.pericentre == Approx(0).margin(1e-13));
  }
}

TEST_CASE("a circular orbit is a circle, and a whole period leads back") {
  for (const double t : {0.1, 2.0, 100.0}) {
    const exact::Motion now = exact::orbit(4, 1, 0, t);  // 2 rad/s
    CHECK(glm::distance(now.x, {std::cos(2 * t), std::sin(2 * t), 0}) <= 1e-13);
    CHECK(glm::dot(now.x, now.v) == Approx(0).margin(1e-14));
  }

  // The double nearest to a period is 2.4493e-16 s short of it: at the pericentre,
  // where gravity is 1e6, that much is still to be slowed down
  const exact::Motion back = exact::orbit(1, 1, 0.999, 2 * k_pi);
  CHECK(glm::distance(back.x, {0.001, 0, 0}) <= 1e-13);
  CHECK(back.v.x == Approx(2.4492935982947064e-10).epsilon(1e-9));
}

TEST_CASE("exact pendulums agree with an independent integration") {
  const auto pull = [](const std::array<double, 2>& y) {
    return std::array{-4 * std::sin(y[0])};
  };

  // Swinging, from far up, through hanging, turning both ways, from beyond a turn
  for (const auto& [x, v] : {std::pair{0.1, 0.0},
                             {3.0, 0.0},
                             {0.0, -3.9},
                             {0.5, 5.0},
                             {-2.0, -7.0},
                             {15.0, 1.0},
                             {-40.0, 4.5}}) {
    const auto y = runge_kutta<1>(pull, {x, v}, 7, 20'000);
    const exact::Coordinate end = exact::pendulum({x, v}, 2, 7);
    INFO(x << ' ' << v);
    CHECK(end.x == Approx(y[0]).margin(1e-10));
    CHECK(end.v == Approx(y[1]).margin(1e-10));
  }
}

TEST_CASE("exact pendulums: small swings, the separatrix, rest") {
  // A swing of 1e-4 rad is harmonic but for theta² / 16 of its phase
  const exact::Coordinate small = exact::pendulum({1e-4, 0}, 3, 5);
  CHECK(small.x == Approx(1e-4 * std::cos(15.0)).margin(1e-4 * 1e-8 / 16 * 15 * 2));
  CHECK(exact::pendulum_period({1e-4, 0}, 3)
        == Approx(2 * k_pi / 3 * (1 + 1e-8 / 16)).epsilon(1e-15));

  // Just enough energy to reach the top, in infinite time: sin(x / 2) = tanh(omega0 t)
  const exact::Coordinate top = exact::pendulum({0, 4}, 2, 1.5);
  CHECK(top.x == Approx(2 * std::asin(std::tanh(3.0))).epsilon(1e-13));
  CHECK(top.v == Approx(4 / std::cosh(3.0)).epsilon(1e-13));
  CHECK(std::isinf(exact::pendulum_period({0, 4}, 2)));

  // From a hair beside the top the distance from it grows as cosh; an angle this
  // close to pi tells the distance to 8e-9
  const double theta0 = 3.1415926;
  const exact::Coordinate beside = exact::pendulum({theta0, 0}, 1, 4);
  CHECK(k_pi - beside.x == Approx((k_pi - theta0) * std::cosh(4.0)).epsilon(1e-8));

  const exact::Coordinate rest = exact::pendulum({0, 0}, 2, 5);
  CHECK(rest.x == 0);
  CHECK(rest.v == 0);

  // Faster than the square of a double can tell: no number, but an answer
  CHECK(std::isnan(exact::pendulum({0, 1e300}, 1, 1).x));
}

TEST_CASE("an exact pendulum is where it was after a period") {
  for (const auto& [x, v] :
       {std::pair{1.0, 0.5}, {3.1, 0.0}, {0.5, 5.0}, {0.5, -5.0}}) {
    const double period = exact::pendulum_period({x, v}, 2);
    const exact::Coordinate end = exact::pendulum({x, v}, 2, 3 * period);
    const double turns = std::abs(v) > 4 ? std::copysign(3.0, v) : 0;
    INFO(x << ' ' << v);
    CHECK(end.x == Approx(x + 2 * k_pi * turns).margin(1e-12));
    CHECK(end.v == Approx(v).margin(1e-12));
  }

  // From a right angle the period is 1.18 times that of small swings
  CHECK(exact::pendulum_period({k_pi / 2, 0}, 1)
        == Approx(2 * k_pi * 1.1803405990160963).epsilon(1e-14));
}

TEST_CASE("two bodies on a spring, and their mirror image") {
  const exact::TwoBodies start{{0, 0.1}, {1.3, 0.2}};
  const auto pull = [](const std::array<double, 4>& y) {
    const double force = 50 * (y[1] - y[0] - 1);
    return std::array{force / 1, -force / 3};
  };
  const auto y = runge_kutta<2>(pull, {0, 1.3, 0.1, 0.2}, 5, 20'000);
  const exact::TwoBodies end = exact::spring_between(start, 1, 3, 50, 1, 5);
  CHECK(end.first.x == Approx(y[0]).margin(1e-10));
  CHECK(end.second.x == Approx(y[1]).margin(1e-10));
  CHECK(end.first.v == Approx(y[2]).margin(1e-10));
  CHECK(end.second.v == Approx(y[3]).margin(1e-10));
  CHECK(end.first.v + 3 * end.second.v == Approx(0.7).epsilon(1e-14));
}

TEST_CASE("a spring pulls its two particles with opposite forces") {
  const std::array<Real, 6> x{0, 0, 0, 3, 4, 0};
  const SpringBetween there{0, 1, 2, 10}, back{1, 0, 2, 10};

  // 10 N/m times an excess of 3 m along (3, 4, 0) / 5
  const Vec3 force = force_on_first(there, x);
  CHECK(glm::distance(force, {18, 24, 0}) <= 8 * k_u * 30);
  CHECK(force_on_first(back, x) == -force);
}

TEST_CASE("gravity is an inverse square towards the origin") {
  const Vec3 a = gravity_towards_origin(50, {3, 4, 0});
  CHECK(glm::distance(a, {Real(-1.2), Real(-1.6), 0}) <= 8 * k_u * 2);
}

TEST_CASE("a double pendulum's energy is conserved by its equations of motion") {
  // dE/dt = dE/dtheta omega + dE/domega alpha, by two-sided differences: h² E''' / 6
  // and u E / h
  const std::array<Real, 2> theta{2, -1}, omega{Real(0.3), -2};
  std::array<Real, 2> alpha{};
  double_pendulum(k_two, theta, omega, alpha);
  const Real h = k_single ? Real(5e-3) : Real(1e-5);
  const auto shifted = [&](Real by) {
    std::array<Real, 2> t = theta, w = omega;
    for (std::size_t i = 0; i < 2; ++i) {
      t[i] += by * omega[i];
      w[i] += by * alpha[i];
    }
    return double(energy(k_two, t, w));
  };
  const double power = (shifted(h) - shifted(-h)) / (2 * h);
  CHECK(power == Approx(0).margin(h * h * 1000 + 16 * k_u * 40 / h));
}

TEST_CASE("a double pendulum's small swings have the two known frequencies") {
  // Equal masses and lengths: omega² = (2 -+ sqrt 2) g / l, with theta2 = +-sqrt 2
  // theta1
  const DoublePendulum equal{1, 1, 1, 1, 1};
  for (const double sign : {1.0, -1.0}) {
    const double root = sign * std::numbers::sqrt2;
    const Real tiny = Real(1e-3);
    const std::array<Real, 2> theta{tiny, tiny * Real(root)}, omega{0, 0};
    std::array<Real, 2> alpha{};
    double_pendulum(equal, theta, omega, alpha);

    // The next terms are theta² smaller
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(alpha[i] / theta[i] == Approx(-(2 - root)).margin(2e-5 + 32 * k_u));
  }
}

TEST_CASE("Runge-Kutta keeps a double pendulum's energy to its order") {
  const Acceleration swing = [](auto x, auto v, Real, auto a) {
    double_pendulum(k_two, x, v, a);
  };
  const State start{.x = {2, 1}, .v = {0, 0}, .a = {0, 0}};
  const double before = energy(k_two, start.x, start.v);
  const auto worst = [&](int n) {
    Integration now = begin(scheme("rk4"), swing, start, Real(2.0 / n));
    double most = 0;
    for (int i = 0; i < n; ++i) {
      advance(now);
      most = std::max(most, std::abs(energy(k_two, now.state.x, now.state.v) - before));
    }
    return most;
  };
  const double coarse = worst(k_single ? 50 : 200);
  const double fine = worst(k_single ? 100 : 400);
  CHECK(std::log2(coarse / fine) == Approx(k_single ? 4.5 : 4).margin(1));
  CHECK(fine < (k_single ? 1e-2 : 1e-5));
}

TEST_CASE("the step that chooses itself follows the tolerance, and says its price") {
  constexpr double e = 0.7;
  const exact::Motion exact = exact::orbit(1, 1, e, 6);
  double last_error = 1;
  long long last_calls = 0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    if (k_single && tolerance < 1e-6) break;
    long long calls = 0;
    const Acceleration counted = [&](auto x, auto v, Real t, auto a) {
      ++calls;
      k_gravity(x, v, t, a);
    };
    State now = orbit_start(e);
    const AdaptiveCost cost =
        dormand_prince(now, counted, 0, 6, {Real(tolerance), Real(tolerance)});
    const double error = glm::distance(glm::dvec3(at(now.x, 0)), exact.x);

    // Every step may be wrong by the tolerance near the pericentre, where the speed is
    // 2.4 and what is off in x shifts the phase (1 + e) / (1 - e)-fold
    INFO(tolerance << ' ' << error);
    const auto steps = double(cost.accepted);
    CHECK(error <= steps * 2.4 * (1 + e) / (1 - e) * tolerance);
    CHECK(error < last_error / 20);
    CHECK(cost.evaluations == calls);
    CHECK(calls == 1 + 6 * (cost.accepted + cost.rejected));

    // A hundredth of the tolerance asks for 100^(1/5) = 2.5 times the steps in the
    // limit
    if (last_calls > 0)
      CHECK(double(calls) / double(last_calls) == Approx(2.2).margin(0.4));
    last_error = error;
    last_calls = calls;
  }
}

TEST_CASE("the step that chooses itself gives up in NaN where there is no motion on") {
  // x'' = 6 x² from x = 1, x' = 2: x = 1 / (1 - t)², which ends at t = 1
  const Acceleration burst = [](auto x, auto, Real, auto a) { a[0] = 6 * x[0] * x[0]; };
  State now{.x = {1}, .v = {2}, .a = {0}};
  dormand_prince(now, burst, 0, Real(0.5), {Real(1e-5), Real(1e-5)});
  CHECK(now.x[0] == Approx(4).epsilon(1e-3));
  dormand_prince(now, burst, Real(0.5), 2, {Real(1e-5), Real(1e-5)});
  CHECK(std::isnan(now.x[0]));
  CHECK(std::isnan(now.v[0]));

  // And where it would take more steps than allowed
  State orbit = orbit_start(0.9);
  const AdaptiveCost cost =
      dormand_prince(orbit, k_gravity, 0, 6, {Real(1e-5), Real(1e-5), 10});
  CHECK(cost.accepted + cost.rejected == 10);
  CHECK(std::isnan(orbit.x[0]));
}

TEST_CASE("constraints of distance move a pair onto its length, the lighter one more") {
  const std::array<DistanceConstraint, 1> rod{{{0, 1, 1}}};
  const std::array<Real, 2> inverse_mass{1, 3};
  std::array<Real, 6> x{0, 0, 0, 3, 0, 4};
  satisfy(rod, inverse_mass, 1, x);

  // The excess of 4 m along (3, 0, 4) / 5, in shares of 1/4 and 3/4
  CHECK(glm::distance(at(x, 0), {Real(0.6), 0, Real(0.8)}) <= 16 * k_u * 5);
  CHECK(glm::distance(at(x, 1), {Real(1.2), 0, Real(1.6)}) <= 16 * k_u * 5);
}

TEST_CASE("constraints of distance keep momentum, hold what is held, and converge") {
  // A chain of unequal masses pulled out of shape; the first particle is held or free
  for (const Real held : {Real(1), Real(0)}) {
    const std::array<Real, 4> inverse_mass{held, 1, Real(0.5), 2};
    const std::array<DistanceConstraint, 3> chain{{{0, 1, 1}, {1, 2, 1}, {2, 3, 1}}};
    const std::array<Real, 12> start{0, 0, 0, 2, 1, 0, 2, 3, 1, 4, 3, 3};
    const auto longest_error = [&](const std::array<Real, 12>& x) {
      double most = 0;
      for (const auto& [i, j, length] : chain)
        most = std::max(most,
                        std::abs(double(glm::distance(at(x, i), at(x, j)) - length)));
      return most;
    };
    double last = longest_error(start);
    for (const int iterations : {1, 10, 100, 1000}) {
      std::array<Real, 12> x = start;
      satisfy(chain, inverse_mass, iterations, x);
      glm::dvec3 momentum{0};
      for (std::size_t i = 0; i < 4; ++i)
        if (inverse_mass[i] > 0)
          momentum += glm::dvec3(at(x, i) - at(start, i)) / double(inverse_mass[i]);

      // A pair's two moves cancel but for the roundings of places of 5 m
      INFO(iterations);
      if (held > 0) CHECK(glm::length(momentum) <= 2 * 5 * k_u * 3 * (iterations + 4));
      if (held == 0) CHECK(at(x, 0) == at(start, 0));
      CHECK(longest_error(x) <= std::max(last, 16 * k_u));
      last = longest_error(x);
    }
    CHECK(last <= 16 * k_u);
  }
}

TEST_CASE("constraints of distance leave alone what they cannot mend") {
  // Two particles at one place, and two that are held
  const std::array<DistanceConstraint, 2> pairs{{{0, 1, 1}, {2, 3, 1}}};
  const std::array<Real, 4> inverse_mass{1, 1, 0, 0};
  const std::array<Real, 12> start{1, 2, 3, 1, 2, 3, 0, 0, 0, 5, 0, 0};
  std::array<Real, 12> x = start;
  satisfy(pairs, inverse_mass, 10, x);
  CHECK(x == start);
}

TEST_CASE("a rod by Verlet and constraint swings as the pendulum") {
  // A rod of 1 m from a right angle for 1 s, which takes it to the other side: of first
  // order, since each correction is along the rod as it is after the step
  const std::array<DistanceConstraint, 1> rod{{{0, 1, 1}}};
  const std::array<Real, 2> inverse_mass{0, 1};
  const Acceleration weight = [](auto, auto, Real, auto a) {
    put(a, 0, {0, 0, 0});
    put(a, 1, {0, Real(-9.81), 0});
  };
  const double exact = exact::pendulum({k_pi / 2, 0}, std::sqrt(9.81), 1).x;
  const auto error = [&](int n) {
    State start = particles(2);
    put(start.x, 1, {1, 0, 0});
    Integration now = begin(scheme("stormer_verlet"), weight, start, Real(1.0 / n));
    for (int i = 0; i < n; ++i) {
      advance(now);
      satisfy(rod, inverse_mass, 1, now.state.x);
    }
    const Vec3 end = at(now.state.x, 1);
    CHECK(glm::length(end) == Approx(1).margin(8 * k_u));
    return std::abs(std::atan2(double(end.x), -double(end.y)) - exact);
  };
  const double fine = error(400);
  CHECK(fine < 0.1);
  CHECK(std::log2(error(200) / fine) == Approx(1).margin(k_single ? 0.2 : 0.1));
}
