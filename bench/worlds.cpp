#include "bench/worlds.hpp"

namespace timestep::world_bench {

std::vector<Engine> engines() {
  std::vector<Engine> all = bench::worlds_of_ours();
  [[maybe_unused]] const auto add = [&](const std::vector<Engine>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
#if defined(TIMESTEP_BULLET)
  add(worlds_of_bullet());
#endif
#if defined(TIMESTEP_ODE)
  add(worlds_of_ode());
#endif
  return all;
}

}  // namespace timestep::world_bench
