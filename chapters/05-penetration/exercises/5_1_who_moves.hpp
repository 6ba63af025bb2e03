/// @file
/// Exercise 5.1, warm-up: Who moves?
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// What two bodies are moved by [m].
struct Shares {
  Vec3 a, b;
};

/// (5.2) How bodies A and B part that are `depth` [m] in each other along the unit
/// normal, which points from A to B. By their inverse masses [1/kg]; one of 0 is that
/// of a wall, which does not move. Two walls stay as they are.
Shares part(Real inverse_mass_a, Real inverse_mass_b, Real depth, const Vec3& normal);

}  // namespace timestep
