/// @file
/// Exercise 2.2, core: The energy that Verlet keeps
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// What velocity Verlet (2.6) keeps to the last digits in steps of dt [s] on a spring
/// of stiffness k [N/m] with a mass m [kg] at x [m] and v [m/s]. At dt = 0 it is the
/// energy m v²/2 + k x²/2 [J].
Real kept_on_spring(Real m, Real k, Real x, Real v, Real dt);

/// What it keeps but for dt⁴ on the pendulum (2.23), omega0² = g/length, at the angle
/// theta [rad] from hanging and the rate omega [rad/s]. At dt = 0 it is the energy,
/// omega²/2 - omega0² cos theta [1/s²] in units of m length².
Real kept_on_pendulum(Real omega0, Real theta, Real omega, Real dt);

}  // namespace timestep
