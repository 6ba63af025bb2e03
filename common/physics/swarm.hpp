/// @file
/// Particles that do not feel each other, such as sparks, rain or dust in a field. Each
/// can take its step alone: its numbers come into registers, stay there from the first
/// line of the method to the last, and go back. The compiler does so with several
/// particles at once, since they lie side by side. Source: chapter 2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// One particle on its own: a state of three coordinates.
struct Particle {
  std::array<Real, 3> x, v, a;
};

/// One coordinate of as many particles as fill a cache line of 64 bytes.
constexpr std::size_t k_lanes = 64 / sizeof(Real);
using Lanes = std::array<Real, k_lanes>;

/// k_lanes particles side by side: a line of all their x[0], then of all their x[1],
/// and so on. `kept` is 2 if the method keeps x and v from step to step, 3 if a as
/// well.
template <std::size_t kept>
struct Pack {
  alignas(64) std::array<std::array<Lanes, 3>, kept> vectors;
};

/// The last pack is filled up with copies of the last particle.
template <std::size_t kept>
struct Swarm {
  std::size_t size;
  std::vector<Pack<kept>> packs;
};

template <std::size_t kept>
inline Particle load(const Pack<kept>& pack, std::size_t lane) {
  Particle p{};
  for (std::size_t k = 0; k < 3; ++k) {
    p.x[k] = pack.vectors[0][k][lane];
    p.v[k] = pack.vectors[1][k][lane];
    if constexpr (kept == 3) p.a[k] = pack.vectors[2][k][lane];
  }
  return p;
}

template <std::size_t kept>
inline void store(const Particle& p, Pack<kept>& pack, std::size_t lane) {
  for (std::size_t k = 0; k < 3; ++k) {
    pack.vectors[0][k][lane] = p.x[k];
    pack.vectors[1][k][lane] = p.v[k];
    if constexpr (kept == 3) pack.vectors[2][k][lane] = p.a[k];
  }
}

/// Calls step(particle) for each of them, for instance
/// `for_each(swarm, [&](Particle& p) { velocity_verlet(p, acceleration, t, dt); })`.
template <std::size_t kept>
inline void for_each(Swarm<kept>& swarm, const auto& step) {
  for (Pack<kept>& pack : swarm.packs)
    for (std::size_t lane = 0; lane < k_lanes; ++lane) {
      Particle p = load(pack, lane);
      step(p);
      store(p, pack, lane);
    }
}

/// The particles of a state with three coordinates for each.
template <std::size_t kept>
Swarm<kept> swarm_of(const State& state) {
  const std::size_t n = state.x.size() / 3;
  Swarm<kept> swarm{n, std::vector<Pack<kept>>((n + k_lanes - 1) / k_lanes)};
  for (std::size_t i = 0; i < swarm.packs.size() * k_lanes; ++i) {
    const std::size_t j = 3 * std::min(i, n - 1);
    const Particle p{.x = {state.x[j], state.x[j + 1], state.x[j + 2]},
                     .v = {state.v[j], state.v[j + 1], state.v[j + 2]},
                     .a = {state.a[j], state.a[j + 1], state.a[j + 2]}};
    store(p, swarm.packs[i / k_lanes], i % k_lanes);
  }
  return swarm;
}

/// And back. What the swarm does not keep is 0.
template <std::size_t kept>
State state_of(const Swarm<kept>& swarm) {
  State state;
  for (std::size_t i = 0; i < swarm.size; ++i) {
    const Particle p = load(swarm.packs[i / k_lanes], i % k_lanes);
    state.x.insert(state.x.end(), p.x.begin(), p.x.end());
    state.v.insert(state.v.end(), p.v.begin(), p.v.end());
    state.a.insert(state.a.end(), p.a.begin(), p.a.end());
  }
  return state;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
