/// @file
/// Rods without forces: particles are moved back to their distance, and Verlet's
/// velocity, the difference of two places, follows by itself. Source: chapter 2;
/// T. Jakobsen, Advanced character physics, GDC 2001.
#pragma once

#include <cstddef>
#include <span>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Particles i and j keep the distance `length` [m].
struct DistanceConstraint {
  std::size_t i, j;
  Real length;
};

/// Equation (2.26): goes through the constraints one after the other, `iterations`
/// times, and moves each pair onto its distance, the lighter one further. x: three
/// numbers a particle [m]; inverse_mass [1/kg]: one a particle, 0 for one that is held.
void satisfy(std::span<const DistanceConstraint> constraints,
             std::span<const Real> inverse_mass, int iterations, std::span<Real> x);

}  // namespace timestep::inline TIMESTEP_PRECISION
