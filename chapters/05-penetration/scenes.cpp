#include "chapters/05-penetration/scenes.hpp"

#include "chapters/05-penetration/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {

std::vector<Scene> scenes() {
  return {overlap_recovery_scene(), feather_and_ball_scene(), tilted_plank_scene(),
          corner_scene()};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
