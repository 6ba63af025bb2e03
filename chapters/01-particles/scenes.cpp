#include "chapters/01-particles/scenes.hpp"

#include <algorithm>

#include "chapters/01-particles/parts.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/euler.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {

std::vector<Scene> scenes() {
  return {projectile_scene(), spring_scene(), fountain_scene(), frame_drops_scene(),
          clock_scene()};
}

std::vector<Method> euler_choices() {
  return {
      {"explicit_euler", "position with the old velocity", method_style(0)},
      {"semi_implicit_euler", "position with the new velocity", method_style(1)},
      {"modified_euler", "with the term a dt²/2", method_style(2)},
  };
}

NamedIntegrator euler_method(std::string_view name) {
  const auto methods = euler_methods();
  return *std::ranges::find(methods, name, &NamedIntegrator::name);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
