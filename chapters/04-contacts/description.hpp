/// @file
/// The bodies that the scenes of chapter 4 put against each other, as plain numbers
/// that serve both precisions.
#pragma once

#include <array>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep::specimens {

/// In the order of the parameters `a` and `b`. The hull has 24 vertices on an
/// ellipsoid, triangle and square are flat, the half-space is all below y = 0.
inline constexpr std::array k_kind_names{"sphere",   "box",    "ellipsoid",   "capsule",
                                         "cylinder", "cone",   "tetrahedron", "hull",
                                         "triangle", "square", "half-space"};
inline constexpr const char* k_kind_help =
    "0 sphere, 1 box, 2 ellipsoid, 3 capsule, 4 cylinder, 5 cone, 6 tetrahedron, 7 "
    "hull, 8 triangle, 9 square";
inline constexpr int k_tetrahedron = 6, k_triangle = 8, k_half_space = 10;

struct Description {
  int kind = 0;
  double size = 0.5;   ///< [m] half its width
  double stretch = 1;  ///< along its own z axis, as a multiple of that
};

/// World from body; the orientation is of length one.
struct Placement {
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
};

}  // namespace timestep::specimens
