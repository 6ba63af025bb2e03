// The linear kinds of chapter 2, computed through the code in common/physics.
#include <algorithm>
#include <array>
#include <cmath>

#include "common/physics/implicit.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/moving_frame.hpp"
#include "tests/truth/pair.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::Pair;
using truth::Place;
using truth::product;
using truth::sum;

// x0 + v0 t + a t² / 2 at t = n dt, in each coordinate
Pair flight(const Json& inputs, int i) {
  const double dt = truth::number(inputs, "dt");
  const auto n = static_cast<double>(truth::steps(inputs));
  const Pair t = product({dt, 0}, n);
  const Pair square = product(product({dt, 0}, dt), n * n);
  return sum({truth::vector(inputs, "x0")[i], 0},
             sum(product(t, truth::vector(inputs, "v0")[i]),
                 product(square, truth::vector(inputs, "a")[i] / 2)));
}

Json constant_acceleration_steps(const Json& inputs) {
  const Run run = constant_acceleration_run(inputs);
  const FineEnd end = fine_end_of(run);

  // Started naively, Störmer's velocity is the difference of the last two places
  const bool kept = run.scheme.name == "stormer_verlet_naive_start";
  const auto& [high, low] = kept ? end.kept : end.now;
  Json fields =
      truth::constant_acceleration_fields(inputs, truth::rounded({high, low}));

  // The error is smaller than the digits of x tell
  for (std::size_t i = 0; i < 3; ++i) {
    const Pair error = difference(sum({high.x[i], 0}, {low.x[i], 0}),
                                  flight(inputs, static_cast<int>(i)));
    fields["x_error"][i] = error.high;
  }
  return fields;
}

// omega dt
Real angle(const Json& inputs) {
  return Real(truth::frequency(inputs) * truth::number(inputs, "dt"));
}

Json oscillator_steps(const Json& inputs) {
  Run run = oscillator_run(inputs);
  const double radius = spectral_radius(step_matrix(run.scheme, angle(inputs)));
  if (!run.scheme.read) {
    Json fields = truth::oscillator_fields(inputs, place_of(end_of(run).state));
    fields["spectral_radius"] = radius;
    return fields;
  }

  // Places alone tell too little of velocities. What these schemes keep is the velocity
  // half a step behind; a step on, half a step ahead
  const FineEnd end = fine_end_of(run);
  Json fields = truth::oscillator_fields(inputs, truth::rounded(end.now));
  fields["spectral_radius"] = radius;
  fields["v_backward"] = truth::rounded(end.kept).v[0];
  ++run.n;
  fields["v_half_forward"] = truth::rounded(fine_end_of(run).kept).v[0];
  return fields;
}

Json oscillator_invariant(const Json& inputs) {
  const Run run = oscillator_run(inputs);
  Json fields =
      invariant_fields(inputs, run.scheme, step_matrix(run.scheme, angle(inputs)));

  // The true energy along the run
  Integration now = begin(run.scheme, run.acceleration, run.start, run.dt);
  double least = truth::oscillator_energy(inputs, place_of(read(now)));
  double most = least;
  for (long long i = 0; i < run.n; ++i) {
    advance(now);
    const double energy = truth::oscillator_energy(inputs, place_of(read(now)));
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  fields["E_min_over_run"] = least;
  fields["E_max_over_run"] = most;
  return fields;
}

Json growth_factor(const Json& inputs) {
  const Real z = Real(truth::not_negative(inputs, "omega_dt"));
  const double radius = spectral_radius(step_matrix(scheme_of(inputs), z));
  return {{"spectral_radius", radius},
          {"energy_factor_per_step_asymptotic", radius * radius}};
}

Json limit_of_stability(const Json& inputs) {
  const double limit = stability_limit(scheme_of(inputs));
  return {{"omega_dt_max", std::isinf(limit) ? Json() : Json(limit)}};
}

// The damped oscillator after n steps, by a scheme or as contact solvers have it
Place damped_end(const Json& inputs, Run run, const Place& start, long long n) {
  run.start = state_of(start);
  run.n = n;
  if (inputs.at("method") != "soft_constraint_implicit_euler")
    return place_of(end_of(run).state);

  const auto get = [&](const char* name) { return Real(truth::number(inputs, name)); };
  auto& [x, v, a] = run.start;
  const Real inverse_mass = 1 / get("m");
  for (; n > 0; --n) {
    v[0] = soft_constraint(x[0], v[0], inverse_mass, get("k"), get("c"), run.dt);
    x[0] += v[0] * run.dt;
  }
  return place_of(run.start);
}

Json damped_oscillator_steps(const Json& inputs) {
  const Run run = damped_oscillator_run(inputs);
  const Place x = damped_end(inputs, run, {{1}, {0}}, 1);
  const Place v = damped_end(inputs, run, {{0}, {1}}, 1);
  Json fields = truth::damped_oscillator_fields(
      inputs, damped_end(inputs, run, place_of(run.start), run.n));
  fields["spectral_radius"] = spectral_radius({x.x[0], v.x[0], x.v[0], v.v[0]});
  return fields;
}

}  // namespace

std::span<const Kind> truth_kinds_02() {
  static constexpr std::array<Kind, 6> kinds{{
      {"constant_acceleration_steps", constant_acceleration_steps},
      {"oscillator_steps", oscillator_steps},
      {"oscillator_invariant", oscillator_invariant},
      {"growth_factor", growth_factor},
      {"stability_limit", limit_of_stability},
      {"damped_oscillator_steps", damped_oscillator_steps},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
