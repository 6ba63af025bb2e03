/// @file
/// What the double pendulum is measured against: no closed form is known, so Dormand
/// and Prince's method at a tight tolerance, in double whatever the run's precision.
/// Compiled in the double build alone, and called from both.
#pragma once

#include <array>

#include "common/physics/precision.hpp"

namespace timestep::double_precision::chapter_02 {

/// Masses [kg] on rods [m] in the field g [m/s²], with their angles from hanging [rad]
/// and rates [rad/s] now.
struct ReferencePendulum {
  double m1, m2, l1, l2, g;
  std::array<double, 2> theta, omega;
};

/// Moves it on by dt [s]; `tolerance`: of a step, relative and absolute. Angles and
/// rates become NaN where this would take more than 30,000 steps.
void advance(ReferencePendulum& pendulum, double dt, double tolerance);

/// Kinetic and potential energy [J] above those of hanging at rest.
double energy_above_rest(const ReferencePendulum& pendulum);

}  // namespace timestep::double_precision::chapter_02
