#include "chapters/02-verlet/scenes.hpp"

#include "chapters/02-verlet/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_02 {

std::vector<Scene> scenes() {
  return {oscillator_scene(),   damped_oscillator_scene(),
          stiff_spring_scene(), pendulum_scene(),
          orbit_scene(),        double_pendulum_scene(),
          rope_scene()};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_02
