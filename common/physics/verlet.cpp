#include "common/physics/verlet.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

void evaluate(State& state, std::span<State>, const Acceleration& acceleration, Real t,
              Real) {
  acceleration(state.x, state.v, t, state.a);
}

void stormer_verlet(State& state, std::span<State> stages,
                    const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  auto& x_previous = stages[0].x;
  acceleration(x, v, t, a);

  // (2.2) The next place from the last two
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Real x_next = 2 * x[i] - x_previous[i] + a[i] * dt * dt;
    v[i] = (x_next - x[i]) / dt;
    x_previous[i] = x[i];
    x[i] = x_next;
  }
}

void stormer_start(State& state, std::span<State> stages,
                   const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (2.3) A step back in time, with the second-order term
  for (std::size_t i = 0; i < x.size(); ++i) {
    stages[0].x[i] = x[i] - v[i] * dt + a[i] * dt * dt / 2;
    v[i] = (x[i] - stages[0].x[i]) / dt;
  }
}

void stormer_naive_start(State& state, std::span<State> stages, const Acceleration&,
                         Real, Real dt) {
  for (std::size_t i = 0; i < state.x.size(); ++i)
    stages[0].x[i] = state.x[i] - state.v[i] * dt;
}

void leapfrog_start(State& state, std::span<State>, const Acceleration& acceleration,
                    Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (2.4) The velocity half a step ago
  for (std::size_t i = 0; i < x.size(); ++i) v[i] -= a[i] * dt / 2;
}

void half_kick(State& state, std::span<State>, const Acceleration& acceleration, Real t,
               Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);

  // (2.5) The half step that the velocity is behind
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * dt / 2;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
