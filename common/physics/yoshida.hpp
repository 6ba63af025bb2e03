/// @file
/// Fourth order out of a second-order step that is its own mirror image: a step too
/// far, a step back, a step too far. Source: chapter 2; H. Yoshida, Construction of
/// higher order symplectic integrators, Physics Letters A 150 (1990) 262.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (2.16) over velocity Verlet (kick, drift, kick): three evaluations, since
/// state.a on entry is as the last step left it. Symplectic; stable on a spring for
/// omega dt < 1.573.
void yoshida4_kdk(State& state, const Acceleration& acceleration, Real t, Real dt);

/// Equation (2.16) over position Verlet (drift, kick, drift): three evaluations.
void yoshida4_dkd(State& state, const Acceleration& acceleration, Real t, Real dt);

}  // namespace timestep::inline TIMESTEP_PRECISION
