/// @file
/// Exact motion of a top that is free of torque, in double, for any three moments.
/// Source: chapter 3; van Zon and Schofield, Numerical implementation of the exact
/// dynamics of free rigid bodies (2007); Landau and Lifshitz, Mechanics, section 37.
#pragma once

#include "common/physics/exact_top.hpp"

namespace timestep::exact {

/// (3.29)-(3.31) A body with the principal moments `inertia` [kg m²], all above 0 and
/// in any order, t seconds after the start without torque. Every motion is covered:
/// spheres and symmetric tops, steady spins, rest, the separatrix. The attitude is
/// right to a few tens of units of round-off of 1 + |omega| t, the angle turned by.
/// What is below 1e-60 of the largest component of omega counts as 0.
Turning free_top(const glm::dvec3& inertia, const Turning& start, double t);

/// Of the motion of omega in the body [rad/s].
struct FreeTopMotion {
  int circulating_axis;  ///< that omega goes round: of the most or the least moment
  double m;              ///< parameter of its elliptic functions, 1 on the separatrix
  double period;         ///< [s]; infinite if omega stays or goes to the middle axis
};

FreeTopMotion free_top_motion(const glm::dvec3& inertia, const glm::dvec3& omega);

/// (3.32) From one flip to the next [s]: half the period.
double flip_interval(const glm::dvec3& inertia, const glm::dvec3& omega);

}  // namespace timestep::exact
