#include "common/physics/verlet_drag.hpp"

#include "common/physics/implicit.hpp"
#include "common/physics/verlet.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// x and half of the kick at the start of a step; the whole Euler step of v goes into
// v_predicted
void drift(State& state, std::span<Real> v_predicted, Real dt) {
  auto& [x, v, a] = state;
  for (std::size_t i = 0; i < x.size(); ++i) {
    v_predicted[i] = v[i] + a[i] * dt;
    v[i] += a[i] * (dt / 2);
    x[i] += v[i] * dt;
  }
}

void kick(State& state, Real dt) {
  for (std::size_t i = 0; i < state.v.size(); ++i) state.v[i] += state.a[i] * dt;
}

}  // namespace

void verlet_lagged(State& state, std::span<State> stages,
                   const Acceleration& acceleration, Real t, Real dt) {
  acceleration(state.x, state.v, t, state.a);
  stages[0].v = state.v;
  drift(state, stages[0].x, dt);

  // (2.8) The acceleration at the new place with the old velocity
  acceleration(state.x, stages[0].v, t + dt, state.a);
  kick(state, dt / 2);
}

void verlet_half(State& state, const Acceleration& acceleration, Real t, Real dt) {
  acceleration(state.x, state.v, t, state.a);

  // (2.9) What velocity Verlet does: the velocity has been kicked half-way
  velocity_verlet(state, acceleration, t, dt);
}

void verlet_predicted(State& state, std::span<State> stages,
                      const Acceleration& acceleration, Real t, Real dt) {
  acceleration(state.x, state.v, t, state.a);
  drift(state, stages[0].v, dt);

  // (2.10) The acceleration at the new place with the predicted velocity
  acceleration(state.x, stages[0].v, t + dt, state.a);
  kick(state, dt / 2);
}

void verlet_implicit(State& state, const Acceleration& acceleration, Real t, Real dt) {
  auto& [x, v, a] = state;
  acceleration(x, v, t, a);
  kick(state, dt / 2);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i] * dt;

  // (2.11) The other half of the kick with the velocity that it leads to
  implicit_kick(state, acceleration, t + dt, dt / 2);
}

void semi_implicit_implicit_drag(State& state, const Acceleration& acceleration, Real t,
                                 Real dt) {
  // (2.12) The kick with the velocity that it leads to, then the drift
  implicit_kick(state, acceleration, t, dt);
  for (std::size_t i = 0; i < state.x.size(); ++i) state.x[i] += state.v[i] * dt;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
