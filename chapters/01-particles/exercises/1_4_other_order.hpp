/// @file
/// Exercise 1.4, core: The other order
#pragma once

#include "common/physics/integrator.hpp"

namespace timestep {

/// Semi-implicit Euler the other way round: moves the positions with the old velocity,
/// then the velocities with the acceleration there, all from time t to t + dt [s].
void drift_kick(State& state, const Acceleration& acceleration, Real t, Real dt);

/// What drift_kick keeps in steps of dt [s] on a spring of stiffness k [N/m] with a
/// mass m [kg] at x [m] and v [m/s]. It becomes the energy m v²/2 + k x²/2 [J] at dt =
/// 0.
Real kept_quantity(Real m, Real k, Real x, Real v, Real dt);

}  // namespace timestep
