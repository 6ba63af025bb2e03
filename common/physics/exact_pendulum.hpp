/// @file
/// Exact motions of chapter 2 beside orbits, in double: the pendulum at every angle,
/// and two bodies on a spring. Source: chapter 2; NIST Handbook of Mathematical
/// Functions (2010), chapters 19 and 22.
#pragma once

#include "common/physics/exact.hpp"

namespace timestep::exact {

/// (2.29) A pendulum, omega0 = sqrt(g / length) [rad/s], t seconds after the start at
/// an angle x [rad] from hanging and a rate v [rad/s]: swinging or turning over, whole
/// turns counted.
Coordinate pendulum(const Coordinate& start, double omega0, double t);

/// (2.30) Its period [s]: of a swing to and fro, or of a turn.
double pendulum_period(const Coordinate& start, double omega0);

/// Places [m] and velocities [m/s] of two bodies on a line.
struct TwoBodies {
  Coordinate first, second;
};

/// (2.31) Masses m1, m2 [kg] on a spring of stiffness k [N/m] and a rest length [m].
TwoBodies spring_between(const TwoBodies& start, double m1, double m2, double k,
                         double length, double t);

}  // namespace timestep::exact
