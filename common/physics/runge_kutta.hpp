/// @file
/// Runge-Kutta methods: several looks at the acceleration within a step, none of them
/// kept. A state carries its own rate of change: x moves with v, v with a. So every
/// stage is a state. Source: chapter 2; E. Hairer, S. P. Norsett, G. Wanner, Solving
/// Ordinary Differential Equations I (1993), chapter II.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (2.13): a step with the rates half-way. Second order; two evaluations; one
/// stage. On a spring the energy grows by 1 + (omega dt)^4 / 4 in every step.
void midpoint(State& state, std::span<State> stages, const Acceleration& acceleration,
              Real t, Real dt);

/// Equation (2.14): the mean of the rates at both ends. As midpoint; one stage.
void heun(State& state, std::span<State> stages, const Acceleration& acceleration,
          Real t, Real dt);

/// Equation (2.15): the classical method. Fourth order; four evaluations; three stages.
/// Stable on a spring for omega dt < 2 sqrt 2, where it damps.
void rk4(State& state, std::span<State> stages, const Acceleration& acceleration,
         Real t, Real dt);

/// Dormand and Prince (1980), fixed step, fifth-order weights. Six evaluations, since
/// the last one serves the next step: state.a on entry as the last step left it. Seven
/// stages, left as the step used them, for an estimate of the error.
void dopri5(State& state, std::span<State> stages, const Acceleration& acceleration,
            Real t, Real dt);

}  // namespace timestep::inline TIMESTEP_PRECISION
