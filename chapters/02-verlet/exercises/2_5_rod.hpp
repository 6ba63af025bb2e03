/// @file
/// Exercise 2.5, challenge: The rod that brakes
#pragma once

#include <span>

#include "common/physics/distance_constraint.hpp"

namespace timestep {

/// A particle whirls about a fixed end of a rod, without gravity. In the last step of
/// (2.2) and (2.26) it turned by `angle` [rad], between 0 and pi; by how much does it
/// turn in the next?
Real next_angle(Real angle);

/// Moves the ends of a rod back to its distance after a step of (2.2), as (2.26) does,
/// such that it does not brake. x, before: three numbers a particle [m], after the step
/// and at its start, where the rod had its length; inverse_mass [1/kg]: one a particle,
/// 0 for one that is held. The rod turns by less than a right angle in a step.
void hold(const DistanceConstraint& rod, std::span<const Real> inverse_mass,
          std::span<const Real> before, std::span<Real> x);

}  // namespace timestep
