// Chapter 2's schemes on the oscillator: the matrix of a step and what it tells,
// against closed forms and against what running the scheme does. Compiled for each
// precision; u (k_u) is the unit round-off of the one at hand.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/physics/stability.hpp"
#include "tests/scheme_run.hpp"

using namespace timestep;

TEST_CASE("on a spring each scheme changes the energy by its own factor") {
  struct Row {
    std::string_view name;
    double (*factor)(double z2);
  };
  constexpr std::array<Row, 8> rows{{
      {"explicit_euler", [](double y) { return 1 + y; }},
      {"midpoint", [](double y) { return 1 + y * y / 4; }},
      {"heun", [](double y) { return 1 + y * y / 4; }},
      {"rk4", [](double y) { return 1 - y * y * y / 72 + y * y * y * y / 576; }},
      {"dopri5",
       [](double y) {
         return 1 + y * y * y * (-1.0 / 1800 + y / 1600 - y * y / 14400)
                + std::pow(y, 6) / 360000;
       }},
      {"implicit_euler", [](double y) { return 1 / (1 + y); }},
      {"implicit_midpoint", [](double) { return 1.0; }},
      {"implicit_trapezoid", [](double) { return 1.0; }},
  }};
  for (const auto& [name, factor] : rows) {
    for (const double z : {0.1, 0.5, 1.0, 2.0}) {
      constexpr int n = 40;
      const State end = read(run(scheme(name), unit_spring, one(0.6, 0.8), z, n));
      const double ratio = double(end.x[0]) * end.x[0] + double(end.v[0]) * end.v[0];

      // A step rounds terms of up to (1 + z)^5 times the state, 8 times each stage
      INFO(name << " z " << z);
      const double h = Real(z);
      CHECK(ratio / std::pow(factor(h * h), n)
            == Approx(1).margin(n * 16 * k_u * std::pow(1 + z, 5)));
    }
  }
}

TEST_CASE("schemes that keep areas keep a modified energy, and so bound the true one") {
  for (const Scheme& s : schemes()) {
    if (!s.symplectic) continue;
    for (const double z : {0.1, 0.5, 1.0, 1.5}) {
      constexpr int n = 1000;
      const double h = Real(z);
      const ModifiedEnergy kept = modified_energy(step_matrix(s, Real(z)), h);
      const EnergyRange range = energy_range(kept);
      const auto modified = [&](const State& at) {
        const double x = at.x[0], v = at.v[0];
        return kept.xx * x * x + kept.xv * x * v + kept.vv * v * v;
      };
      Integration now = begin(s, unit_spring, one(0.6, 0.8), Real(z));
      const double start = modified(read(now));
      double drift = 0, least = 1, most = 0;
      for (int i = 0; i < n; ++i) {
        advance(now);
        const State at = read(now);
        const double energy =
            (double(at.x[0]) * at.x[0] + double(at.v[0]) * at.v[0]) / 2;
        drift = std::max(drift, std::abs(modified(at) / start - 1));
        least = std::min(least, energy);
        most = std::max(most, energy);
      }

      // Up to 16 roundings a step of the state, whose true energy is up to most/least
      // times the kept one; Störmer's are velocities of 4 u x / z
      const double bound =
          n * 16 * k_u * (range.most / range.least) * (is_stormer(s) ? 1 + 1 / z : 1);
      INFO(s.name << " z " << z);
      CHECK(drift <= bound);
      CHECK(least >= start * range.least * (1 - bound));
      CHECK(most <= start * range.most * (1 + bound));
      CHECK(most - least >= 0.6 * start * (range.most - range.least) - bound);
    }
  }
}

TEST_CASE("the limits of stability are those of the closed forms") {
  const auto limit = [](std::string_view name) -> double {
    if (name == "explicit_euler" || name == "modified_euler") return 0;
    if (name == "midpoint" || name == "heun") return 0;
    if (name == "rk4") return 2 * std::numbers::sqrt2;
    if (name == "dopri5") return 0.9971890086325299;
    if (name.starts_with("yoshida4")) return 1.573401947434540;
    if (name.starts_with("implicit")) return std::numeric_limits<double>::infinity();
    return 2;
  };
  for (const Scheme& s : schemes()) {
    // Some 20 roundings of the trace or of the radius, over its slope at the limit: 1
    // at least, but 5e-4 of dopri5
    const double rise = s.name == "dopri5" ? 5e-4 : 1;
    INFO(s.name);
    CHECK(stability_limit(s) == Approx(limit(s.name)).margin(20 * k_u / rise));
  }
}

TEST_CASE("below its limit a scheme stays bounded, above it blows up") {
  for (const Scheme& s : schemes()) {
    const double limit = stability_limit(s);
    if (limit == 0 || std::isinf(limit)) continue;
    const auto largest = [&](double z, int n) {
      Integration now = begin(s, unit_spring, one(1, 0), Real(z));
      double most = 0;
      for (int i = 0; i < n; ++i) {
        advance(now);
        most = std::max(most, std::abs(double(now.state.x[0])));
      }
      return most;
    };

    // Just below, x is on an ellipse no longer than 1 / sqrt(1 - (z / limit)²), or what
    // grows first shrinks. Just above, dopri5 grows by only 1e-5 a step
    INFO(s.name);
    const int n = s.name == "dopri5" ? 500'000 : 2000;
    CHECK(largest(0.99 * limit, n) <= 2 / std::sqrt(1 - 0.99 * 0.99));
    CHECK(largest(1.02 * limit, n) > 100);
  }
}

TEST_CASE("drag lowers the limit, or raises it if taken from the new velocity") {
  // omega = 1, zeta = 1/2: 2 (sqrt(1 + zeta²) -+ zeta)
  const double root = std::sqrt(1.25);
  const auto grows = [](std::string_view name, double z) {
    const State end =
        read(run(scheme(name), spring_and_damper(1, 1), one(1, 0), z, 1000));
    return !(std::abs(end.x[0]) <= 1e3);
  };
  CHECK_FALSE(grows("semi_implicit_euler", 0.99 * 2 * (root - 0.5)));
  CHECK(grows("semi_implicit_euler", 1.01 * 2 * (root - 0.5)));
  CHECK_FALSE(grows("semi_implicit_implicit_drag", 0.99 * 2 * (root + 0.5)));
  CHECK(grows("semi_implicit_implicit_drag", 1.01 * 2 * (root + 0.5)));
}

TEST_CASE("the frequency that a scheme makes of omega") {
  for (const double z : {1e-3, 0.1, 1.0, 1.9}) {
    const double h = Real(z);
    const auto ratio = [&](std::string_view name) {
      return frequency_ratio(step_matrix(scheme(name), Real(z)), h);
    };

    // Conjugate schemes: one frequency. Near z = 2 its sine is sqrt(1 - z²/4), which
    // divides the 16 roundings of the matrix
    const double verlet = 2 / h * std::asin(h / 2);
    const double bound = 16 * k_u / std::sqrt(1 - z * z / 4);
    for (const char* name : {"semi_implicit_euler", "semi_implicit_euler_drift_kick",
                             "velocity_verlet", "position_verlet", "leapfrog"})
      CHECK(ratio(name) == Approx(verlet).margin(bound));
    CHECK(ratio("implicit_midpoint")
          == Approx(2 / h * std::atan(h / 2)).margin(16 * k_u));
  }
}

TEST_CASE("eigenvalues of a critically damped step are told as one") {
  // (1 - c dt / 2) twice: a root of the rounding of their difference would be 1e-8
  constexpr double dt = Real(0.02);
  const StepMatrix m{1, dt, -4 * dt, 1 - 4 * dt};
  CHECK(spectral_radius(m) == Approx(1 - 2 * dt).margin(4 * k_u));
}

TEST_CASE("what Störmer reads at the start does not change its matrix") {
  for (const char* name :
       {"stormer_verlet", "stormer_verlet_naive_start", "leapfrog"}) {
    const double z = 0.5;
    const StepMatrix m = step_matrix(scheme(name), Real(z));
    const StepMatrix v = step_matrix(scheme("velocity_verlet"), Real(z));
    for (const double off : {m.xx - v.xx, m.xv - v.xv, m.vx - v.vx, m.vv - v.vv})
      CHECK(off == Approx(0).margin(16 * k_u / z));
  }
}
