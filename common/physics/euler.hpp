/// @file
/// The three Euler methods: one evaluation of the acceleration a step, first order.
/// Source: chapter 1; thesis, Formula 1 and section 2.1.
#pragma once

#include <span>

#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (1.3). Position with the old velocity, velocity with the old acceleration.
/// Position error after time t under constant a: -a t dt / 2. On a spring the energy
/// grows by the factor 1 + (ω dt)² in every step, whatever dt.
void explicit_euler(State& state, const Acceleration& acceleration, Real t, Real dt);

/// Equation (1.4), thesis Formula 1 (Euler-Cromer). Position with the new velocity.
/// Position error after time t under constant a: +a t dt / 2. Symplectic; stable on a
/// spring for ω dt < 2.
void semi_implicit_euler(State& state, const Acceleration& acceleration, Real t,
                         Real dt);

/// Equation (1.5): explicit Euler with the term a dt²/2 ("taylor2" in the truth files).
/// Exact for constant a. On a spring the energy grows by 1 + (ω dt)²/2 in every step.
void modified_euler(State& state, const Acceleration& acceleration, Real t, Real dt);

/// The three above, in that order.
std::span<const NamedIntegrator> euler_methods();

}  // namespace timestep::inline TIMESTEP_PRECISION
