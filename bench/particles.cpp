// Particles per second, in cache and in memory: every method on whole arrays, those
// that can take a particle alone also on a swarm, some by hand; and what memory gives.
//
// The particles are oscillators, a = -omega² x in every coordinate: hardly a cheaper
// force exists, so what shows is the price of the method.
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/by_hand.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/runge_kutta.hpp"
#include "common/physics/schemes.hpp"
#include "common/physics/swarm.hpp"
#include "common/physics/yoshida.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

constexpr Real k_omega2 = Real(1.3), k_dt = Real(0.01);
const std::vector<std::size_t> k_counts{4096, 1'000'000};
constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

constexpr auto k_oscillators = [](auto x, auto, Real, auto a) {
  for (std::size_t i = 0; i < x.size(); ++i) a[i] = -k_omega2 * x[i];
};

// n particles at different phases
State cloud(std::size_t n) {
  State state = particles(n);
  for (std::size_t i = 0; i < 3 * n; ++i) {
    state.x[i] = Real(std::sin(double(i)));
    state.v[i] = Real(std::cos(double(i)));
  }
  evaluate(state, k_oscillators, 0);
  return state;
}

std::string name(const std::string& what, std::size_t n) {
  return what + (k_single ? "/single/" : "/double/") + std::to_string(n);
}

// How much was done: steps of n particles, and numbers that had to be read or written.
// A step reads and writes the `kept` vectors of each particle.
void count_particles(benchmark::State& run, std::size_t n) {
  run.SetItemsProcessed(run.iterations() * static_cast<long long>(n));
}
void count_numbers(benchmark::State& run, std::size_t n) {
  run.SetBytesProcessed(run.iterations() * static_cast<long long>(n * sizeof(Real)));
}
void count_particles(benchmark::State& run, std::size_t n, std::size_t kept) {
  count_particles(run, n);
  count_numbers(run, 2 * 3 * kept * n);
  run.counters["kept"] = static_cast<double>(kept);
}

// --- the methods ---------------------------------------------------------------------

void measure_whole(benchmark::State& run, const Scheme& scheme, std::size_t n) {
  Integration all = begin(scheme, k_oscillators, cloud(n), k_dt);
  for ([[maybe_unused]] auto _ : run) advance(all);
  count_particles(run, n);
}

// Methods that solve d equations in d coordinates get one particle
void add_whole(const Scheme& scheme) {
  const bool solves = scheme.evaluations == 0;
  const std::string what = "particles/" + std::string(scheme.name) + "/whole";
  for (const std::size_t n : solves ? std::vector<std::size_t>{1} : k_counts)
    benchmark::RegisterBenchmark(name(what, n).c_str(), measure_whole, scheme, n);
}

template <std::size_t kept>
void add_swarm(const std::string& method, auto step) {
  for (const std::size_t n : k_counts) {
    const auto measure = [=](benchmark::State& run) {
      Swarm<kept> swarm = swarm_of<kept>(cloud(n));
      benchmark::DoNotOptimize(swarm.packs.data());
      for ([[maybe_unused]] auto _ : run) {
        for_each(swarm, step);
        benchmark::ClobberMemory();
      }
      count_particles(run, n, kept);
    };
    benchmark::RegisterBenchmark(name("particles/" + method + "/swarm", n).c_str(),
                                 measure);
  }
}

template <std::size_t kept>
void add_by_hand(const std::string& method, auto step) {
  for (const std::size_t n : k_counts) {
    const auto measure = [=](benchmark::State& run) {
      State state = cloud(n);
      benchmark::DoNotOptimize(state);
      for ([[maybe_unused]] auto _ : run) {
        step(state);
        benchmark::ClobberMemory();
      }
      count_particles(run, n, kept);
    };
    benchmark::RegisterBenchmark(name("particles/" + method + "/by_hand", n).c_str(),
                                 measure);
  }
}

// --- what the memory gives -----------------------------------------------------------

// STREAM's triad a = b + s c. The line that a number is written to is read before, so
// four numbers move where STREAM counts three.
void measure_triad(benchmark::State& run, std::size_t n) {
  std::vector<Real> a(n / 3, 1), b(n / 3, 2), c(n / 3, 3);
  for ([[maybe_unused]] auto _ : run) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + k_omega2 * c[i];
    benchmark::ClobberMemory();
  }
  count_numbers(run, 4 * a.size());
}

// A pass that reads and writes every number in its place, as a step does
void measure_update(benchmark::State& run, std::size_t n) {
  std::vector<Real> a(n, 1);
  for ([[maybe_unused]] auto _ : run) {
    for (Real& number : a) number = 2 - number;
    benchmark::ClobberMemory();
  }
  count_numbers(run, 2 * a.size());
}

// On as many numbers as a swarm has that keeps so many vectors of each particle
void add_bandwidth(std::size_t kept) {
  const std::size_t n = 3 * kept * k_counts.back();
  const std::string end = name("", k_counts.back()) + "/" + std::to_string(kept);
  benchmark::RegisterBenchmark(("bandwidth/triad" + end).c_str(), measure_triad, n);
  benchmark::RegisterBenchmark(("bandwidth/update" + end).c_str(), measure_update, n);
}

}  // namespace

void add_particles() {
  for (const Scheme& scheme : schemes()) add_whole(scheme);

  add_swarm<2>("semi_implicit_euler",
               [](Particle& p) { kick_drift(p, k_oscillators, 0, k_dt); });
  add_swarm<2>("semi_implicit_euler_drift_kick", [](Particle& p) {
    semi_implicit_euler_drift_kick(p, k_oscillators, 0, k_dt);
  });
  add_swarm<3>("velocity_verlet",
               [](Particle& p) { velocity_verlet(p, k_oscillators, 0, k_dt); });
  add_swarm<2>("position_verlet",
               [](Particle& p) { position_verlet(p, k_oscillators, 0, k_dt); });
  add_swarm<3>("yoshida4_kdk",
               [](Particle& p) { yoshida4_kdk(p, k_oscillators, 0, k_dt); });
  add_swarm<2>("yoshida4_dkd",
               [](Particle& p) { yoshida4_dkd(p, k_oscillators, 0, k_dt); });
  add_swarm<2>("midpoint", [](Particle& p) {
    std::array<Particle, 1> stages;
    midpoint(p, stages, k_oscillators, 0, k_dt);
  });
  add_swarm<2>("heun", [](Particle& p) {
    std::array<Particle, 1> stages;
    heun(p, stages, k_oscillators, 0, k_dt);
  });
  add_swarm<2>("rk4", [](Particle& p) {
    std::array<Particle, 3> stages;
    rk4(p, stages, k_oscillators, 0, k_dt);
  });
  add_swarm<3>("dopri5", [](Particle& p) {
    std::array<Particle, 7> stages;
    dopri5(p, stages, k_oscillators, 0, k_dt);
  });

#if defined(TIMESTEP_HAS_SIMD)
  add_by_hand<2>("semi_implicit_euler", [](State& s) {
    by_hand::semi_implicit_euler(s.x, s.v, k_omega2, k_dt);
  });
  add_by_hand<3>("velocity_verlet", [](State& s) {
    by_hand::velocity_verlet(s.x, s.v, s.a, k_omega2, k_dt);
  });
  add_by_hand<2>("position_verlet",
                 [](State& s) { by_hand::position_verlet(s.x, s.v, k_omega2, k_dt); });
  add_by_hand<2>("rk4", [](State& s) { by_hand::rk4(s.x, s.v, k_omega2, k_dt); });
#endif

  add_bandwidth(2);
  add_bandwidth(3);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
