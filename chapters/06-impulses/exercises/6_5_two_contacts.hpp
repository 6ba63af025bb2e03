/// @file
/// Exercise 6.5, challenge: Two contacts at once
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// The normal impulses z [N s] of two contacts, (6.14) with k = 2: K (symmetric, its
/// determinant and its diagonal greater than 0) is in 1/kg, v are the speeds [m/s] at
/// which they part before. Afterwards none closes, none pulls, and none that parts
/// pushes: K z + v >= 0, z >= 0, and of each contact one of the two is 0.
glm::dvec2 two_contacts(const glm::dmat2& K, const glm::dvec2& v);

}  // namespace timestep
