/// @file
/// The Verlet family: one evaluation of the acceleration a step, second order, and the
/// energy stays near its true value for ever, as long as forces do not depend on the
/// velocity and omega dt < 2. Source: chapter 2; thesis, Formulas 2 and 3.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Evaluates the acceleration at t: how schemes start that reuse the last one.
void evaluate(State& state, std::span<State>, const Acceleration& acceleration, Real t,
              Real dt);

/// Equation (2.1): the other symplectic Euler, position first. First order.
inline void semi_implicit_euler_drift_kick(auto& state, const auto& acceleration,
                                           Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.1) The old velocity moves the position, the new position gives the acceleration
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * dt;
  evaluate(state, acceleration, t + dt);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * dt;
}

/// Equation (2.2), thesis Formula 2: x from the two places before. stages[0].x is the
/// previous place; state.v is the backward difference, the velocity half a step ago.
void stormer_verlet(State& state, std::span<State> stages,
                    const Acceleration& acceleration, Real t, Real dt);

/// Equation (2.3): the place before the start such that order 2 holds.
void stormer_start(State& state, std::span<State> stages,
                   const Acceleration& acceleration, Real t, Real dt);

/// The place before the start as x - v dt, as often seen: what follows is semi-implicit
/// Euler, of first order.
void stormer_naive_start(State& state, std::span<State> stages,
                         const Acceleration& acceleration, Real t, Real dt);

/// Leapfrog's step: semi-implicit Euler, equation (1.4), for any state.
inline void kick_drift(auto& state, const auto& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  evaluate(state, acceleration, t);
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * dt;
    x[i] += v[i] * dt;
  }
}

/// Equation (2.4): semi-implicit Euler is leapfrog, once v stands half a step back.
void leapfrog_start(State& state, std::span<State> stages,
                    const Acceleration& acceleration, Real t, Real dt);

/// Equation (2.5): v at t from v half a step ago.
void half_kick(State& state, std::span<State> stages, const Acceleration& acceleration,
               Real t, Real dt);

/// Equation (2.6), thesis Formula 3, as kick, drift, kick. Takes state.a at the start
/// of the step as the last step left it: for forces that depend on x and t alone.
inline void velocity_verlet(auto& state, const auto& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.6) Half a kick with the acceleration of the last step, a drift
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * (dt / 2);
    x[i] += v[i] * dt;
  }

  // The other half of the kick, with the acceleration at the new place
  evaluate(state, acceleration, t + dt);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * (dt / 2);
}

/// Equation (2.7): drift, kick, drift.
inline void position_verlet(auto& state, const auto& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.7) Half a drift, a kick with the acceleration in the middle, half a drift
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * (dt / 2);
  evaluate(state, acceleration, t + dt / 2);
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * dt;
    x[i] += v[i] * (dt / 2);
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
