/// @file
/// Who moves the scenes: our solvers, Bullet and ODE.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/world_measures.hpp"
#include "common/physics/precision.hpp"

namespace timestep {

namespace world_bench {

/// A library's world, set up from a scene and settings, as a simulation.
template <class World>
Simulation simulation(const Scene& scene, const Settings& settings, auto... more) {
  const auto world = std::make_shared<World>(scene, settings, more...);
  return {[world] { world->step(); }, [world] { return world->states(); }};
}

}  // namespace world_bench

namespace single_precision::bench {
std::vector<world_bench::Engine> worlds_of_ours();
}  // namespace single_precision::bench
namespace double_precision::bench {
std::vector<world_bench::Engine> worlds_of_ours();
}  // namespace double_precision::bench

namespace world_bench {
std::vector<Engine> worlds_of_bullet();  ///< in the precision that is linked
std::vector<Engine> worlds_of_ode();

/// All that this program has: our solvers in the precision that it was built for.
std::vector<Engine> engines();
}  // namespace world_bench

}  // namespace timestep
