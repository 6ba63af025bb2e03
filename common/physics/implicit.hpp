/// @file
/// Implicit methods: the rates at the end of the step move the state there, so the end
/// must be solved for. Stable for every omega dt. Newton's method with differences for
/// derivatives: d + 1 evaluations and a system of d equations an iteration, two or
/// three iterations a step. Where it finds no answer, x and v become NaN. Source:
/// chapter 2.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (2.17): v' = v + a(x', v', t + dt) dt, x' = x + v' dt. First order; takes
/// energy out of every oscillation: on a spring E falls by 1 + (omega dt)² a step.
void implicit_euler(State& state, const Acceleration& acceleration, Real t, Real dt);

/// Equation (2.18): half a step of implicit Euler, then half of explicit Euler. Second
/// order, symplectic.
void implicit_midpoint(State& state, const Acceleration& acceleration, Real t, Real dt);

/// Equation (2.19): half a step of explicit Euler, then half of implicit Euler. Second
/// order; conjugate to the midpoint, so energy stays near its value, too.
void implicit_trapezoid(State& state, const Acceleration& acceleration, Real t,
                        Real dt);

/// v' = v + a(x, v', t) dt at a place x that stays: for drag.
void implicit_kick(State& state, const Acceleration& acceleration, Real t, Real dt);

/// Implicit Euler for one spring of stiffness k [N/m] with damper c [kg/s] and a mass
/// on it, solved by hand: equation (2.20). x [m] from rest, v [m/s]. In contact solvers
/// this goes by the name of soft constraint (Catto, GDC 2011). Returns the new v; then
/// x += v dt.
inline Real soft_constraint(Real x, Real v, Real inverse_mass, Real k, Real c,
                            Real dt) {
  const Real softness = dt * (c + dt * k) * inverse_mass;
  return (v - dt * k * x * inverse_mass) / (1 + softness);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
