#include "common/physics/dormand_prince.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/runge_kutta.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// Fifth-order weights less fourth-order ones
constexpr std::array<Real, 7> k_difference{Real(71.0 / 57600),      0,
                                           Real(-71.0 / 16695),     Real(71.0 / 1920),
                                           Real(-17253.0 / 339200), Real(22.0 / 525),
                                           Real(-1.0 / 40)};

// The largest estimated error of a step, in units of what is allowed
Real error_of(const State& state, std::span<const State> stages, Real dt,
              const Tolerance& tolerance) {
  Real most = 0;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    Real x = 0;
    Real v = 0;
    for (std::size_t j = 0; j < k_difference.size(); ++j) {
      x += k_difference[j] * stages[j].v[i];
      v += k_difference[j] * stages[j].a[i];
    }
    const auto allowed = [&](Real before, Real after) {
      return tolerance.absolute
             + tolerance.relative * std::max(std::abs(before), std::abs(after));
    };
    most = std::max({most, std::abs(dt * x) / allowed(stages[0].x[i], state.x[i]),
                     std::abs(dt * v) / allowed(stages[0].v[i], state.v[i])});
    if (std::isnan(x + v)) return std::numeric_limits<Real>::infinity();
  }
  return most;
}

// A first step over which nothing changes by more than a hundredth
Real first_step(const State& state, Real whole) {
  Real dt = whole;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    if (state.v[i] != 0 && state.x[i] != 0)
      dt = std::min(dt, std::abs(state.x[i] / state.v[i]) / 100);
    if (state.a[i] != 0 && state.v[i] != 0)
      dt = std::min(dt, std::abs(state.v[i] / state.a[i]) / 100);
  }
  return std::max(dt, whole * Real(1e-6));
}

void give_up(State& state) {
  std::ranges::fill(state.x, std::numeric_limits<Real>::quiet_NaN());
  std::ranges::fill(state.v, std::numeric_limits<Real>::quiet_NaN());
}

}  // namespace

AdaptiveCost dormand_prince(State& state, const Acceleration& acceleration, Real t,
                            Real t_end, const Tolerance& tolerance) {
  std::vector<State> stages(7, state);
  acceleration(state.x, state.v, t, state.a);
  AdaptiveCost cost{.evaluations = 1};
  Real dt = first_step(state, t_end - t);

  while (t < t_end) {
    // A step, and how far the two orders are apart
    const bool last = t + dt >= t_end;
    if (last) dt = t_end - t;
    dopri5(state, stages, acceleration, t, dt);
    cost.evaluations += 6;
    const Real error = error_of(state, stages, dt, tolerance);

    // (2.21) Kept if the error is allowed; the next step such that it just will be
    if (error <= 1) {
      t = last ? t_end : t + dt;
      ++cost.accepted;
    } else {
      state = stages[0];
      ++cost.rejected;
    }
    dt *= std::clamp(Real(0.9) * std::pow(error, Real(-0.2)), Real(0.2), Real(5));
    const bool too_many = cost.accepted + cost.rejected == tolerance.most_steps;
    if (t < t_end && (t + dt == t || too_many)) {
      give_up(state);
      return cost;
    }
  }
  return cost;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
