#include "common/physics/yoshida.hpp"

#include "common/physics/verlet.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// 1 / (2 - 2^(1/3)); the errors of third order cancel in 2 w1³ + (1 - 2 w1)³ = 0
constexpr Real w1 = Real(1.3512071919596576341);
constexpr Real w0 = 1 - 2 * w1;

// (2.16) Three steps of lengths w1, w0, w1, which sum up to one: also when rounded
void triple_jump(Integrator step, State& state, const Acceleration& acceleration,
                 Real t, Real dt) {
  step(state, acceleration, t, w1 * dt);
  step(state, acceleration, t + w1 * dt, w0 * dt);
  step(state, acceleration, t + (w1 + w0) * dt, w1 * dt);
}

}  // namespace

void yoshida4_kdk(State& state, const Acceleration& acceleration, Real t, Real dt) {
  triple_jump(velocity_verlet, state, acceleration, t, dt);
}

void yoshida4_dkd(State& state, const Acceleration& acceleration, Real t, Real dt) {
  triple_jump(position_verlet, state, acceleration, t, dt);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
