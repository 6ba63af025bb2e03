#include "chapters/04-contacts/scenes.hpp"

#include "chapters/04-contacts/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

std::vector<Scene> scenes() {
  return {step_by_step_scene(), pairs_scene(), mesh_scene(), sweep_scene()};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
