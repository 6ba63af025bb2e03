/// @file
/// Free bodies as every library gets them: principal moments 1, 2 and 2.5 kg m², no
/// force, no collisions, sixty steps a second.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "common/physics/exact_free_top.hpp"
#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {

constexpr glm::dvec3 k_inertia{1, 2, 2.5};
constexpr int k_steps_a_second = 60;
constexpr glm::dvec3 k_top_spin{1, 2, 3};             // [rad/s]
constexpr glm::dvec3 k_dzhanibekov_spin{.1, 10, .1};  // [rad/s], the unstable axis

/// n angular velocities [rad/s] of about 4 rad/s, about all kinds of axes.
inline std::vector<glm::dvec3> various_spins(std::size_t n) {
  std::vector<glm::dvec3> spins;
  for (std::size_t i = 0; i < n; ++i) {
    const auto phase = static_cast<double>(i);
    spins.emplace_back(3 * std::sin(phase), 3 * std::cos(phase),
                       3 * std::sin(phase / 3));
  }
  return spins;
}

inline double energy(const exact::Turning& body) {
  return exact::rotational_energy(body, k_inertia);
}

/// A free top after 1, 10 and 100 s, beside what is exact. What has exploded until then
/// has no number.
void compare_top(benchmark::State& run, const auto& make) {
  const exact::Turning start{{1, 0, 0, 0}, k_top_spin};
  auto top = make(std::vector{start.omega});
  int steps = 0;
  for (const int seconds : {1, 10, 100}) {
    for (; steps < seconds * k_steps_a_second; ++steps) top.step();
    const exact::Turning should_be = exact::free_top(k_inertia, start, seconds);
    const double error = exact::angle_between(should_be.q, top.first().q);
    if (!std::isfinite(error)) return;
    run.counters["attitude_error_" + std::to_string(seconds) + "_s"] = error;
  }
  run.counters["energy_change"] = energy(top.first()) / energy(start) - 1;
}

/// How often the spin about the middle axis changes its sign in 60 s, and the share by
/// which its energy changes; nothing if it explodes.
void count_flips(benchmark::State& run, const auto& make) {
  auto nut = make(std::vector{k_dzhanibekov_spin});
  const double energy_at_start = energy(nut.first());
  double flips = 0, sign = 1;
  for (int i = 0; i < 60 * k_steps_a_second; ++i) {
    nut.step();
    if (nut.first().omega.y * sign >= 0) continue;
    sign = -sign;
    ++flips;
  }
  const double change = energy(nut.first()) / energy_at_start - 1;
  if (!std::isfinite(change)) return;
  run.counters["flips"] = flips;
  run.counters["flips_energy_change"] = change;
}

/// Adds rotation/NAME/COUNT, the time of many bodies, and top/NAME, what becomes of
/// one. make(spins) sets bodies up that turn at angular velocities in [rad/s]; step()
/// of what it returns moves them all, and first() says how the first one turns.
void add_bodies(const std::string& name, const auto& make) {
  for (const std::size_t n : {std::size_t{1000}, std::size_t{100'000}}) {
    const auto measure = [=](benchmark::State& run) {
      auto bodies = make(various_spins(n));
      bodies.step();  // the first one also allocates
      for ([[maybe_unused]] auto _ : run) {
        bodies.step();
        benchmark::ClobberMemory();
      }
      run.SetItemsProcessed(run.iterations() * static_cast<long long>(n));
    };
    benchmark::RegisterBenchmark(("rotation/" + name + "/" + std::to_string(n)).c_str(),
                                 measure);
  }
  benchmark::RegisterBenchmark(("top/" + name).c_str(), [=](benchmark::State& run) {
    compare_top(run, make);
    count_flips(run, make);
    for ([[maybe_unused]] auto _ : run) continue;  // there must be something to time
  });
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
