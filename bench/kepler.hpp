/// @file
/// Kepler's problem as every library gets it: GM = 1, semi-major axis 1, eccentricity
/// 1/2, from the pericentre, a thousand steps an orbit.
#pragma once

#include <algorithm>
#include <cmath>

#include <benchmark/benchmark.h>

#include "common/physics/systems.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {

constexpr int k_steps_an_orbit = 1000;
constexpr double k_dt = 2 * 3.14159265358979323846 / k_steps_an_orbit;
constexpr double k_pericentre = 0.5;
const double k_speed = std::sqrt(3.0);  // there

inline double energy(const Vec3& x, const Vec3& v) {
  return glm::dot(v, v) / 2 - 1 / glm::length(x);
}

/// Takes the steps of make(), an object with step(t), x() and v(), and says how far its
/// energy ever was off, as a share, in twenty orbits.
void measure_orbit(benchmark::State& run, const auto& make) {
  auto watched = make();
  const double at_start = energy(watched.x(), watched.v());
  double worst = 0;
  for (int i = 0; i < 20 * k_steps_an_orbit; ++i) {
    watched.step(i * k_dt);
    const double now = energy(watched.x(), watched.v());
    worst = std::max(worst, std::abs(now / at_start - 1));
  }
  run.counters["energy_error"] = worst;

  auto timed = make();
  for ([[maybe_unused]] auto _ : run) {
    for (int i = 0; i < k_steps_an_orbit; ++i) timed.step(i * k_dt);
    benchmark::ClobberMemory();
  }
  benchmark::DoNotOptimize(timed.x());
  run.SetItemsProcessed(run.iterations() * k_steps_an_orbit);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
