#include "chapters/06-impulses/scenes.hpp"

#include "chapters/06-impulses/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

std::vector<Scene> scenes() {
  return {
      two_blocks_scene(),    impact_scene(),        bounce_scene(),
      cradle_scene(),        billiards_scene(),     elastic_gas_scene(),
      ramp_scene(),          slide_to_roll_scene(), rod_scene(),
      rocking_block_scene(), stack_scene(),         pyramid_scene(),
      pile_scene(),          mass_ratio_scene(),    thin_wall_scene(),
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
