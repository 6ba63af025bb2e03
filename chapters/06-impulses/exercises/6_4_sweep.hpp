/// @file
/// Exercise 6.4, core: Remember the sum
#pragma once

#include <span>

#include "common/physics/real.hpp"

namespace timestep {

/// One sweep, (6.11), from the lowest contact to the highest, over bodies on top of
/// each other that move up and down only. Body 0 is the ground. Contact i is between
/// body i and body i + 1, and `impulses[i]` [N s] is what it has given so far:
/// -impulses[i] to the lower body, impulses[i] to the upper one, and the velocities
/// [m/s, upwards] have that in them already. Contacts ask for no parting speed, never
/// pull, and do nothing for two bodies that nothing can move. Both lists are changed.
void sweep(std::span<const Real> inverse_masses, std::span<Real> velocities,
           std::span<Real> impulses);

}  // namespace timestep
