#include "chapters/03-rigid-bodies/scenes.hpp"

#include "chapters/03-rigid-bodies/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {

std::vector<Scene> scenes() {
  return {thrown_wrench_scene(), torque_free_scene(), dzhanibekov_scene(),
          symmetric_top_scene(), heavy_top_scene(),   cue_strike_scene(),
          spin_up_scene()};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
