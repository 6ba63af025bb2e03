// Chapter 2's schemes: their orders, what they are to each other, what they keep and
// what they cost. Compiled for each precision; u (k_u) is the unit round-off of the one
// at hand, every tolerance a count of roundings times u times the size of what is
// rounded.
#include <array>
#include <cmath>
#include <numbers>

#include "common/physics/exact_pendulum.hpp"
#include "common/physics/implicit.hpp"
#include "tests/scheme_run.hpp"

using namespace timestep;

namespace {

// The power of the step with which the error falls from n to n_finer steps.
template <class Error>
double slope(const Error& error, int n, int n_finer) {
  return std::log(error(n) / error(n_finer)) / std::log(double(n_finer) / n);
}

}  // namespace

TEST_CASE("every scheme converges with its order on the pendulum") {
  constexpr double T = 3;
  const auto exact = exact::pendulum({1, 0.5}, 1, T);
  for (const Scheme& s : schemes()) {
    const auto error = [&](int n) {
      const State end = read(run(s, unit_pendulum, one(1, 0.5), T / n, n));
      return std::hypot(end.x[0] - exact.x, end.v[0] - exact.v);
    };

    // In single the steps are so long that errors stay a hundred times above rounding;
    // there the next power of the step shows: up to a quarter of an order
    INFO(s.name);
    if (!k_single)
      CHECK(slope(error, 64, 256) == Approx(s.order).margin(0.05));
    else if (s.order == 1)
      CHECK(slope(error, 64, 256) == Approx(1).margin(0.05));
    else if (s.order == 2)
      CHECK(slope(error, 16, 64) == Approx(2).margin(0.05));
    else
      CHECK(slope(error, s.order == 4 ? 8 : 2, s.order == 4 ? 16 : 4)
            == Approx(s.order).margin(0.25));
  }
}

TEST_CASE("midpoint and modified Euler are two methods, of orders 2 and 1") {
  // The thesis has them as one. On a spring they differ by z³/4 after one step already
  const State m = read(run(scheme("midpoint"), unit_spring, one(1, 1), 0.5, 1));
  const State e = read(run(scheme("modified_euler"), unit_spring, one(1, 1), 0.5, 1));
  CHECK(m.x[0] == Approx(e.x[0]).margin(8 * k_u));
  CHECK(e.v[0] - m.v[0] == Approx(0.5 * 0.5 / 2).margin(8 * k_u));
  CHECK(scheme("midpoint").order == 2);
  CHECK(scheme("modified_euler").order == 1);
}

TEST_CASE("under constant acceleration a scheme is off by a t dt / 2 or not at all") {
  constexpr double a = -9.81, dt = 1.0 / 60, t = 2, x0 = 1, v0 = 20;
  constexpr int n = 120;
  const Acceleration fall = [](auto, auto, Real, auto out) { out[0] = Real(a); };
  const auto sign = [](std::string_view name) {
    if (name == "explicit_euler" || name == "semi_implicit_euler_drift_kick") return -1;
    if (name == "semi_implicit_euler" || name == "implicit_euler") return 1;
    if (name == "semi_implicit_implicit_drag") return 1;
    return name == "stormer_verlet_naive_start" ? 1 : 0;
  };
  for (const auto list : {schemes(), drag_schemes()}) {
    for (const Scheme& s : list) {
      // Up to 6 roundings a step of v (at most 20 m/s), each carried on for t, and of x
      // (at most 22 m). Störmer rounds x by 2 u, which is a velocity of 2 u x / dt
      const double rounding = 6 * k_u * n * (20 * t + 22);
      const double of_stormer = is_stormer(s) ? 2 * k_u * n * 22 * t / dt : 0;
      const State end = read(run(s, fall, one(x0, v0), dt, n));
      INFO(s.name);
      const double exact = x0 + v0 * t + a * t * t / 2;
      CHECK(end.x[0] - exact
            == Approx(sign(s.name) * a * t * dt / 2).margin(rounding + of_stormer));
    }
  }
}

TEST_CASE("Störmer, leapfrog and velocity Verlet are one method") {
  constexpr double dt = 0.05;
  constexpr int n = 100;
  const State v =
      read(run(scheme("velocity_verlet"), unit_pendulum, one(1, 0.5), dt, n));
  const State l = read(run(scheme("leapfrog"), unit_pendulum, one(1, 0.5), dt, n));
  const State s =
      read(run(scheme("stormer_verlet"), unit_pendulum, one(1, 0.5), dt, n));

  // The pendulum's tangent map grows at most linearly with time: by 1 + t. A step makes
  // 4 roundings of numbers below 1.2; Störmer's count 1/dt times as velocities
  constexpr double bound = 4 * 1.2 * k_u * n * (1 + n * dt);
  CHECK(l.x[0] == Approx(v.x[0]).margin(bound));
  CHECK(l.v[0] == Approx(v.v[0]).margin(bound));
  CHECK(s.x[0] == Approx(v.x[0]).margin(bound / dt));
  CHECK(s.v[0] == Approx(v.v[0]).margin(bound / dt));
}

TEST_CASE("Störmer with the naive start is semi-implicit Euler") {
  constexpr double dt = 0.05;
  constexpr int n = 100;
  const Integration e =
      run(scheme("semi_implicit_euler"), unit_pendulum, one(1, 0.5), dt, n);
  const Integration s =
      run(scheme("stormer_verlet_naive_start"), unit_pendulum, one(1, 0.5), dt, n);
  constexpr double bound = 4 * 1.2 * k_u * n * (1 + n * dt) / dt;
  CHECK(s.state.x[0] == Approx(e.state.x[0]).margin(bound));
  CHECK(s.state.v[0] == Approx(e.state.v[0]).margin(bound));

  // And so it is a step's error off from Verlet, far beyond rounding
  const State v =
      read(run(scheme("velocity_verlet"), unit_pendulum, one(1, 0.5), dt, n));
  CHECK(std::abs(s.state.x[0] - v.x[0]) > 0.005);
}

TEST_CASE("without drag the schemes for drag are those that they are named after") {
  constexpr double dt = 0.05;
  constexpr int n = 100;
  constexpr double bound = 12 * 1.2 * k_u * n * (1 + n * dt);
  for (const Scheme& s : drag_schemes()) {
    const bool euler = s.name == "semi_implicit_implicit_drag";
    const Scheme& same = scheme(euler ? "semi_implicit_euler" : "velocity_verlet");
    const State end = read(run(s, unit_pendulum, one(1, 0.5), dt, n));
    const State expected = read(run(same, unit_pendulum, one(1, 0.5), dt, n));
    INFO(s.name);
    CHECK(end.x[0] == Approx(expected.x[0]).margin(bound));
    CHECK(end.v[0] == Approx(expected.v[0]).margin(bound));
  }
}

TEST_CASE("a soft constraint is implicit Euler") {
  constexpr Real k = 400, c = 3, inverse_mass = Real(0.5), dt = Real(1) / 60;
  const Acceleration soft = spring_and_damper(k * inverse_mass, c * inverse_mass);
  Integration euler = begin(scheme("implicit_euler"), soft, one(0.2, -1), dt);
  Real x = Real(0.2), v = -1;

  // 60 steps of some 20 roundings of numbers up to the largest speed, 2.9 m/s; the
  // solver may leave 2 u of the terms of its equation, k x dt / m and v
  for (int i = 0; i < 60; ++i) {
    advance(euler);
    v = soft_constraint(x, v, inverse_mass, k, c, dt);
    x += v * dt;
    CHECK(double(v) == Approx(euler.state.v[0]).margin(60 * 20 * k_u * 3));
  }
}

TEST_CASE("the trapezoid is the midpoint, seen half a step earlier") {
  // T = I E and M = E I with E, I half a step of explicit, implicit Euler: E T = M E
  constexpr double dt = 0.1;
  constexpr int n = 50;
  const auto half = [&](const State& state) {
    return read(run(scheme("explicit_euler"), unit_pendulum, state, dt / 2, 1));
  };
  const State trapezoid =
      half(read(run(scheme("implicit_trapezoid"), unit_pendulum, one(1, 0.5), dt, n)));
  const State midpoint =
      read(run(scheme("implicit_midpoint"), unit_pendulum, half(one(1, 0.5)), dt, n));
  constexpr double bound = 20 * 1.2 * k_u * n * (1 + n * dt);
  CHECK(trapezoid.x[0] == Approx(midpoint.x[0]).margin(bound));
  CHECK(trapezoid.v[0] == Approx(midpoint.v[0]).margin(bound));
}

TEST_CASE("Yoshida's steps are three Verlet steps of lengths that cancel third order") {
  const double w1 = 1 / (2 - std::cbrt(2.0));
  const double w0 = 1 - 2 * w1;
  CHECK(2 * w1 * w1 * w1 + w0 * w0 * w0 == Approx(0).margin(1e-14));
  for (const auto& [whole, part] : {std::pair{"yoshida4_kdk", "velocity_verlet"},
                                    {"yoshida4_dkd", "position_verlet"}}) {
    State state = one(1, 0.5);
    for (const double w : {w1, w0, w1})
      state = read(run(scheme(part), unit_pendulum, state, w * 0.3, 1));
    const State end = read(run(scheme(whole), unit_pendulum, one(1, 0.5), 0.3, 1));
    CHECK(end.x[0] == Approx(state.x[0]).margin(24 * k_u));
    CHECK(end.v[0] == Approx(state.v[0]).margin(24 * k_u));
  }
}

TEST_CASE("symplectic schemes keep an orbit's angular momentum, others do not") {
  constexpr double e = 0.5;
  const double v0 = std::sqrt((1 + e) / (1 - e));
  constexpr int n = 400;  // two orbits
  const Acceleration gravity = [](auto x, auto, Real, auto a) {
    put(a, 0, gravity_towards_origin(1, at(x, 0)));
  };
  State start = particles(1);
  put(start.x, 0, {Real(1 - e), 0, 0});
  put(start.v, 0, {0, Real(v0), 0});
  for (const Scheme& s : schemes()) {
    if (s.evaluations == 0 && s.name != "implicit_midpoint") continue;
    const double dt = 4 * std::numbers::pi / n;
    const auto L = [](const State& at) {
      return double(at.x[0]) * at.v[1] - double(at.x[1]) * at.v[0];
    };
    const Integration first = run(s, gravity, start, dt, 0);
    const double before = L(read(first));
    const double change = L(read(run(s, gravity, start, dt, n))) / before - 1;

    // Up to 12 roundings a step of x and v, with |x| |v| below 1.3; Störmer's of x
    // count as velocities of 2 u |x| / dt at |x| of up to 1.5. A solver's last
    // correction is below 2 u of terms that are twice as large
    double bound = n * 12 * k_u * 1.3;
    if (is_stormer(s)) bound += n * 2 * k_u * 1.5 * 1.5 / dt;
    INFO(s.name);
    if (s.symplectic)
      CHECK(std::abs(change) <= bound);
    else if (s.order < (k_single ? 2 : 4))
      CHECK(std::abs(change) > 10 * bound);
  }
}

TEST_CASE("a step back undoes a step of the reversible schemes alone") {
  constexpr double dt = 0.8;
  for (const Scheme& s : schemes()) {
    const State there = read(run(s, unit_pendulum, one(1, 0.5), dt, 1));
    const State back = read(run(s, unit_pendulum, there, -dt, 1));
    const double off = std::hypot(back.x[0] - 1, back.v[0] - 0.5);

    // Some 20 roundings of numbers near 1, each way; Störmer's count 1/dt times. What
    // is left of a step that is not its own mirror image is the error of its order,
    // twice: at this length 1e-5 at least
    INFO(s.name << " is off by " << off);
    if (s.reversible)
      CHECK(off <= 80 * k_u);
    else
      CHECK(off > (k_single ? 100 * k_u : 1e-5));
  }
}

TEST_CASE("a step evaluates the acceleration as often as the scheme says") {
  for (const auto list : {schemes(), drag_schemes()}) {
    for (const Scheme& s : list) {
      int calls = 0;
      const Acceleration counted = [&](auto x, auto, Real, auto a) {
        ++calls;
        a[0] = -x[0];
      };
      Integration now = begin(s, counted, one(1, 0), Real(0.1));
      calls = 0;
      for (int i = 0; i < 10; ++i) advance(now);
      INFO(s.name);
      if (s.evaluations > 0)
        CHECK(calls == 10 * s.evaluations);
      else
        CHECK((calls >= 20 && calls <= 100));  // Newton: 2 an iteration, 1 to 5 of them
    }
  }
}

TEST_CASE("time passes for the force as for the motion") {
  // x'' = 6 t + 2: x = t³ + t². A scheme that looks at the wrong times loses its order
  const Acceleration growing = [](auto, auto, Real t, auto a) { a[0] = 6 * t + 2; };
  for (const Scheme& s : schemes()) {
    const auto error = [&](int n) {
      const State end = read(run(s, growing, one(0, 0), 1.0 / n, n));
      return std::hypot(end.x[0] - 2.0, end.v[0] - 5.0);
    };
    INFO(s.name);
    if (s.order == 1)
      CHECK(slope(error, 64, 128) == Approx(1).margin(0.1));
    else if (s.order == 2)
      CHECK(slope(error, 8, 16) == Approx(2).margin(0.1));
    else
      CHECK(error(8) <= 8 * 20 * 5 * k_u);  // exact but for rounding
  }
}

TEST_CASE("with drag two of the four velocity Verlets drop to first order") {
  const auto exact = exact::oscillator({1, 0.3}, 2, 0.4, 2);
  for (const Scheme& s : drag_schemes()) {
    const auto error = [&](int n) {
      const State end =
          read(run(s, spring_and_damper(4, Real(0.8)), one(1, 0.3), 2.0 / n, n));
      return std::hypot(end.x[0] - exact.x, end.v[0] - exact.v);
    };
    INFO(s.name);
    CHECK(slope(error, 32, 128) == Approx(s.order).margin(k_single ? 0.1 : 0.05));
  }
  constexpr std::array orders{1, 1, 2, 2, 1};
  for (std::size_t i = 0; i < orders.size(); ++i)
    CHECK(drag_schemes()[i].order == orders[i]);
}

TEST_CASE("a step of an implicit scheme that does not exist ends in NaN") {
  // x'' = x² with dt = 1 from x = 1: w = (1 + w)² has no real root
  const Acceleration square = [](auto x, auto, Real, auto a) { a[0] = x[0] * x[0]; };
  const State end = read(run(scheme("implicit_euler"), square, one(1, 0), 1, 1));
  CHECK(std::isnan(end.x[0]));
  CHECK(std::isnan(end.v[0]));
}

TEST_CASE("implicit schemes solve stiff, slow and far-off steps alike") {
  // x'' = -(x - away): the end of a step in closed form
  for (const double z : {1e-3, 1.0, 2.0001, 50.0, 1000.0}) {
    for (const double away : {0.0, 1.0, 1000.0}) {
      for (const auto& [x, v] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1e-3, -20.0}}) {
        const Acceleration pull = [&](auto place, auto, Real, auto a) {
          a[0] = -(place[0] - Real(away));
        };
        const State end = read(run(scheme("implicit_euler"), pull, one(x, v), z, 1));

        // The roundings of x - away and of v, z-fold as velocities, are divided by 1+z²
        const double h = Real(z);
        const double w = (Real(v) - h * (Real(x) - away)) / (1 + h * h);
        const double size = std::abs(v) + h * (std::abs(x) + 2 * away);
        INFO(z << ' ' << away << ' ' << x << ' ' << v);
        CHECK(end.v[0]
              == Approx(w).margin(16 * k_u * size / (1 + h * h) + 4 * k_u * size));
      }
    }
  }
}

TEST_CASE("four answers to which velocity the drag at the end of a step is of") {
  // Drag alone, c dt = 1/2: what a step leaves of the velocity
  constexpr double y = 0.5;
  const auto left = [&](std::string_view name) {
    return double(
        read(run(scheme(name), spring_and_damper(0, 1), one(0, 1), y, 1)).v[0]);
  };
  CHECK(left("verlet_lagged") == Approx(1 - y).margin(8 * k_u));
  CHECK(left("verlet_half") == Approx((1 - y / 2) * (1 - y / 2)).margin(8 * k_u));
  CHECK(left("verlet_predicted") == Approx(1 - y + y * y / 2).margin(8 * k_u));
  CHECK(left("verlet_implicit") == Approx((1 - y / 2) / (1 + y / 2)).margin(8 * k_u));
  CHECK(left("semi_implicit_implicit_drag") == Approx(1 / (1 + y)).margin(8 * k_u));
}
