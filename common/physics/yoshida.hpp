/// @file
/// Fourth order out of a second-order step that is its own mirror image: a step too
/// far, a step back, a step too far. Source: chapter 2; H. Yoshida, Construction of
/// higher order symplectic integrators, Physics Letters A 150 (1990) 262.
#pragma once

#include "common/physics/verlet.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (2.16): calls step(t, dt) three times, with lengths that sum up to dt.
inline void triple_jump(const auto& step, Real t, Real dt) {
  // 1 / (2 - 2^(1/3)); the errors of third order cancel in 2 w1³ + (1 - 2 w1)³ = 0
  constexpr Real w1 = Real(1.3512071919596576341);
  constexpr Real w0 = 1 - 2 * w1;

  // (2.16) Three steps of lengths w1, w0, w1, which sum up to one: also when rounded
  step(t, w1 * dt);
  step(t + w1 * dt, w0 * dt);
  step(t + (w1 + w0) * dt, w1 * dt);
}

/// Equation (2.16) over velocity Verlet (kick, drift, kick): three evaluations, since
/// state.a on entry is as the last step left it. Symplectic; stable on a spring for
/// omega dt < 1.573.
inline void yoshida4_kdk(auto& state, const auto& acceleration, Real t, Real dt) {
  triple_jump([&](Real from, Real h) { velocity_verlet(state, acceleration, from, h); },
              t, dt);
}

/// Equation (2.16) over position Verlet (drift, kick, drift): three evaluations.
inline void yoshida4_dkd(auto& state, const auto& acceleration, Real t, Real dt) {
  triple_jump([&](Real from, Real h) { position_verlet(state, acceleration, from, h); },
              t, dt);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
