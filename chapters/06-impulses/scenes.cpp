#include "chapters/06-impulses/scenes.hpp"

#include "chapters/06-impulses/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

std::vector<Scene> scenes() {
  return {
      two_blocks_scene(),
      impact_scene(),
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
