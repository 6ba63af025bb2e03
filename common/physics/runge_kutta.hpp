/// @file
/// Runge-Kutta methods: several looks at the acceleration within a step, none of them
/// kept. A state carries its own rate of change: x moves with v, v with a. So every
/// stage is a state. Source: chapter 2; E. Hairer, S. P. Norsett, G. Wanner, Solving
/// Ordinary Differential Equations I (1993), chapter II.
#pragma once

#include <array>

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// to = from + h (rates of the state `rate`)
template <typename S>
inline void shift(const S& from, const S& rate, Real h, S& to) {
  for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] = from.x[i] + h * rate.v[i];
  for (std::size_t i = 0; i < to.v.size(); ++i) to.v[i] = from.v[i] + h * rate.a[i];
}

/// to = stages[0] + h (sum of the stages' rates with these weights)
template <typename S, std::size_t n>
inline void shift(Stages<S> stages, const std::array<Real, n>& weights, Real h, S& to) {
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    Real v = weights[0] * stages[0].v[i];
    for (std::size_t j = 1; j < n; ++j) v += weights[j] * stages[j].v[i];
    to.x[i] = stages[0].x[i] + h * v;
  }
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    Real a = weights[0] * stages[0].a[i];
    for (std::size_t j = 1; j < n; ++j) a += weights[j] * stages[j].a[i];
    to.v[i] = stages[0].v[i] + h * a;
  }
}

/// Equation (2.13): a step with the rates half-way. Second order; two evaluations; one
/// stage. On a spring the energy grows by 1 + (omega dt)^4 / 4 in every step.
template <typename S>
inline void midpoint(S& state, Stages<S> stages, const auto& acceleration, Real t,
                     Real dt) {
  evaluate(state, acceleration, t);

  // (2.13) Half an Euler step to look at the rates there, then the step with them
  S& middle = stages[0];
  shift(state, state, dt / 2, middle);
  evaluate(middle, acceleration, t + dt / 2);
  shift(state, middle, dt, state);
}

/// Equation (2.14): the mean of the rates at both ends. As midpoint; one stage.
template <typename S>
inline void heun(S& state, Stages<S> stages, const auto& acceleration, Real t,
                 Real dt) {
  evaluate(state, acceleration, t);

  // (2.14) An Euler step to look at the rates there, then half of each
  S& end = stages[0];
  shift(state, state, dt, end);
  evaluate(end, acceleration, t + dt);
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] += dt / 2 * (state.v[i] + end.v[i]);
    state.v[i] += dt / 2 * (state.a[i] + end.a[i]);
  }
}

/// Equation (2.15): the classical method. Fourth order; four evaluations; three stages.
/// Stable on a spring for omega dt < 2 sqrt 2, where it damps.
template <typename S>
inline void rk4(S& state, Stages<S> stages, const auto& acceleration, Real t, Real dt) {
  // (2.15) The rates at the start, twice half-way, at the end
  S &k1 = state, &k2 = stages[0], &k3 = stages[1], &k4 = stages[2];
  evaluate(k1, acceleration, t);
  shift(state, k1, dt / 2, k2);
  evaluate(k2, acceleration, t + dt / 2);
  shift(state, k2, dt / 2, k3);
  evaluate(k3, acceleration, t + dt / 2);
  shift(state, k3, dt, k4);
  evaluate(k4, acceleration, t + dt);

  // Simpson's weights
  for (std::size_t i = 0; i < state.x.size(); ++i)
    state.x[i] += dt / 6 * (k1.v[i] + 2 * (k2.v[i] + k3.v[i]) + k4.v[i]);
  for (std::size_t i = 0; i < state.x.size(); ++i)
    state.v[i] += dt / 6 * (k1.a[i] + 2 * (k2.a[i] + k3.a[i]) + k4.a[i]);
}

/// Dormand and Prince (1980), fixed step, fifth-order weights. Six evaluations, since
/// the last one serves the next step: state.a on entry as the last step left it. Seven
/// stages, left as the step used them, for an estimate of the error.
template <typename S>
inline void dopri5(S& state, Stages<S> stages, const auto& acceleration, Real t,
                   Real dt) {
  constexpr auto ratio = [](double p, double q) { return static_cast<Real>(p / q); };
  constexpr std::array<Real, 1> a2{ratio(1, 5)};
  constexpr std::array<Real, 2> a3{ratio(3, 40), ratio(9, 40)};
  constexpr std::array<Real, 3> a4{ratio(44, 45), ratio(-56, 15), ratio(32, 9)};
  constexpr std::array<Real, 4> a5{ratio(19372, 6561), ratio(-25360, 2187),
                                   ratio(64448, 6561), ratio(-212, 729)};
  constexpr std::array<Real, 5> a6{ratio(9017, 3168), ratio(-355, 33),
                                   ratio(46732, 5247), ratio(49, 176),
                                   ratio(-5103, 18656)};
  constexpr std::array<Real, 6> b{ratio(35, 384),     0,
                                  ratio(500, 1113),   ratio(125, 192),
                                  ratio(-2187, 6784), ratio(11, 84)};
  const auto look = [&](std::size_t stage, const auto& weights, Real c) {
    S& k = stages[stage];
    shift(stages, weights, dt, k);
    evaluate(k, acceleration, t + c * dt);
  };

  // Five looks from the start of the step, then the step; its end is the seventh stage
  stages[0] = state;
  look(1, a2, ratio(1, 5));
  look(2, a3, ratio(3, 10));
  look(3, a4, ratio(4, 5));
  look(4, a5, ratio(8, 9));
  look(5, a6, 1);
  look(6, b, 1);
  state = stages[6];
}

}  // namespace timestep::inline TIMESTEP_PRECISION
