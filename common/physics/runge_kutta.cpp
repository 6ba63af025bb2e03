#include "common/physics/runge_kutta.hpp"

#include <array>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// to = from + h (rates of the state `rate`)
void shift(const State& from, const State& rate, Real h, State& to) {
  for (std::size_t i = 0; i < from.x.size(); ++i) {
    to.x[i] = from.x[i] + h * rate.v[i];
    to.v[i] = from.v[i] + h * rate.a[i];
  }
}

// to = stages[0] + h (sum of the stages' rates with these weights)
template <std::size_t n>
void shift(std::span<const State> stages, const std::array<Real, n>& weights, Real h,
           State& to) {
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    Real v = 0;
    Real a = 0;
    for (std::size_t j = 0; j < n; ++j) {
      v += weights[j] * stages[j].v[i];
      a += weights[j] * stages[j].a[i];
    }
    to.x[i] = stages[0].x[i] + h * v;
    to.v[i] = stages[0].v[i] + h * a;
  }
}

constexpr Real ratio(double p, double q) {
  return static_cast<Real>(p / q);
}

}  // namespace

void midpoint(State& state, std::span<State> stages, const Acceleration& acceleration,
              Real t, Real dt) {
  acceleration(state.x, state.v, t, state.a);

  // (2.13) Half an Euler step to look at the rates there, then the step with them
  State& middle = stages[0];
  shift(state, state, dt / 2, middle);
  acceleration(middle.x, middle.v, t + dt / 2, middle.a);
  shift(state, middle, dt, state);
}

void heun(State& state, std::span<State> stages, const Acceleration& acceleration,
          Real t, Real dt) {
  acceleration(state.x, state.v, t, state.a);

  // (2.14) An Euler step to look at the rates there, then half of each
  State& end = stages[0];
  shift(state, state, dt, end);
  acceleration(end.x, end.v, t + dt, end.a);
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] += dt / 2 * (state.v[i] + end.v[i]);
    state.v[i] += dt / 2 * (state.a[i] + end.a[i]);
  }
}

void rk4(State& state, std::span<State> stages, const Acceleration& acceleration,
         Real t, Real dt) {
  // (2.15) The rates at the start, twice half-way, at the end
  State &k1 = state, &k2 = stages[0], &k3 = stages[1], &k4 = stages[2];
  acceleration(k1.x, k1.v, t, k1.a);
  shift(state, k1, dt / 2, k2);
  acceleration(k2.x, k2.v, t + dt / 2, k2.a);
  shift(state, k2, dt / 2, k3);
  acceleration(k3.x, k3.v, t + dt / 2, k3.a);
  shift(state, k3, dt, k4);
  acceleration(k4.x, k4.v, t + dt, k4.a);

  // Simpson's weights
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] += dt / 6 * (k1.v[i] + 2 * (k2.v[i] + k3.v[i]) + k4.v[i]);
    state.v[i] += dt / 6 * (k1.a[i] + 2 * (k2.a[i] + k3.a[i]) + k4.a[i]);
  }
}

void dopri5(State& state, std::span<State> stages, const Acceleration& acceleration,
            Real t, Real dt) {
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
    State& k = stages[stage];
    shift(stages, weights, dt, k);
    acceleration(k.x, k.v, t + c * dt, k.a);
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
