/// @file
/// What the scenes of chapter 1 share, and each of them.
#pragma once

#include <string_view>
#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {

Scene projectile_scene();
Scene spring_scene();
Scene fountain_scene();
Scene frame_drops_scene();
Scene clock_scene();

/// The three Euler methods as a scene offers them.
std::vector<Method> euler_choices();

/// The method of that name; it must be one of euler_choices().
NamedIntegrator euler_method(std::string_view name);

/// Vectors of a picture and of a file from those of the physics.
inline glm::vec3 picture(const glm::dvec3& v) {
  return glm::vec3(v);
}
inline glm::dvec3 wide(const Vec3& v) {
  return glm::dvec3(v);
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
