/// @file
/// Velocity Verlet where the force depends on the velocity, as drag does: the end of
/// the step needs a velocity that is not known yet. Four answers; two of them cost an
/// order. Two evaluations a step. Source: chapter 2.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (2.8) with the velocity at the start of the step: first order.
void verlet_lagged(State& state, std::span<State> stages,
                   const Acceleration& acceleration, Real t, Real dt);

/// (2.9) with the velocity half-way, as velocity Verlet has it at hand: first order.
void verlet_half(State& state, const Acceleration& acceleration, Real t, Real dt);

/// (2.10) with Euler's prediction v + a dt: second order.
void verlet_predicted(State& state, std::span<State> stages,
                      const Acceleration& acceleration, Real t, Real dt);

/// (2.11) with the velocity at the end, solved for: second order, and stable for any
/// drag.
void verlet_implicit(State& state, const Acceleration& acceleration, Real t, Real dt);

/// (2.12) Semi-implicit Euler with the new velocity in the force, solved for: first
/// order; drag then helps stability: omega dt < 2 (zeta + sqrt(1 + zeta²)).
void semi_implicit_implicit_drag(State& state, const Acceleration& acceleration, Real t,
                                 Real dt);

}  // namespace timestep::inline TIMESTEP_PRECISION
