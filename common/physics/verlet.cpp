#include "common/physics/verlet.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

void evaluate(State& state, std::span<State>, const Acceleration& acceleration, Real t,
              Real) {
  acceleration(state.x, state.v, t, state.a);
}

void semi_implicit_euler_drift_kick(State& state, const Acceleration& acceleration,
                                    Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.1) The old velocity moves the position, the new position gives the acceleration
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * dt;
  acceleration(x, v, t + dt, a);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * dt;
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

void velocity_verlet(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.6) Half a kick with the acceleration of the last step, a drift
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * (dt / 2);
    x[i] += v[i] * dt;
  }

  // The other half of the kick, with the acceleration at the new place
  acceleration(x, v, t + dt, a);
  for (std::size_t i = 0; i < x.size(); ++i) v[i] += a[i] * (dt / 2);
}

void position_verlet(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;

  // (2.7) Half a drift, a kick with the acceleration in the middle, half a drift
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * (dt / 2);
  acceleration(x, v, t + dt / 2, a);
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += a[i] * dt;
    x[i] += v[i] * (dt / 2);
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
