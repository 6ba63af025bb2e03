/// @file
/// Exercise 6.3, core: A skate
#pragma once

#include "common/physics/impulse.hpp"

namespace timestep {

/// What a blade on ice resists with: along it hardly, across it strongly. The first
/// components are along the blade, the second across.
struct Skate {
  glm::dvec2 friction;    ///< coefficients, greater than 0
  double normal_impulse;  ///< [N s] 0 or more
  double effective_mass;  ///< [kg] the same in all directions
};

/// The friction impulse [N s] on a skate that slips with the velocity `slip` [m/s]: the
/// one that ends the slip, if it lies within the ellipse with half the axes friction
/// times normal_impulse; else the one in the ellipse that leaves the least energy.
glm::dvec2 friction_impulse(const Skate& skate, const glm::dvec2& slip);

}  // namespace timestep
