#include "tests/truth/runs.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "common/graphics/input_error.hpp"
#include "common/physics/schemes.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

using truth::Json;
using truth::Place;

namespace {

Acceleration spring_and_damper(double k, double c, double m) {
  return [k = Real(k), c = Real(c), inverse_mass = Real(1 / m)](auto x, auto v, Real,
                                                                auto a) {
    a[0] = -(k * x[0] + c * v[0]) * inverse_mass;
  };
}

Acceleration pendulum_of(double g, double length) {
  return [g = Real(g), length = Real(length)](auto x, auto, Real, auto a) {
    a[0] = pendulum(g, length, x[0]);
  };
}

}  // namespace

Scheme scheme_of(const Json& inputs) {
  auto name = inputs.at("method").get<std::string>();
  if (name == "taylor2") name = "modified_euler";
  if (name == "leapfrog_staggered") name = "leapfrog";
  const Scheme* scheme = find_scheme(name);
  if (!scheme) throw truth::NotCovered("method " + name);
  return *scheme;
}

Run constant_acceleration_run(const Json& inputs) {
  const glm::dvec3 x = truth::vector(inputs, "x0");
  const glm::dvec3 v = truth::vector(inputs, "v0");
  return {.scheme = scheme_of(inputs),
          .acceleration = [a = Vec3(truth::vector(inputs, "a"))](
                              auto, auto, Real, auto out) { put(out, 0, a); },
          .start = state_of({{x.x, x.y, x.z}, {v.x, v.y, v.z}}),
          .dt = Real(truth::number(inputs, "dt")),
          .n = truth::steps(inputs)};
}

Run oscillator_run(const Json& inputs) {
  const double m = truth::positive(inputs, "m");
  const double k = truth::not_negative(inputs, "k");
  return {
      .scheme = scheme_of(inputs),
      .acceleration = spring_and_damper(k, 0, m),
      .start = state_of({{truth::number(inputs, "x0")}, {truth::number(inputs, "v0")}}),
      .dt = Real(truth::number(inputs, "dt")),
      .n = truth::steps(inputs)};
}

Run damped_oscillator_run(const Json& inputs) {
  // Schemes that keep the last acceleration do so for forces without drag; with drag,
  // velocity Verlet takes the velocity that it has at hand
  Json renamed = inputs;
  const Json& method = inputs.at("method");
  if (method == "velocity_verlet") renamed["method"] = "verlet_half";
  if (method == "soft_constraint_implicit_euler") renamed["method"] = "implicit_euler";
  Run run = oscillator_run(renamed);
  if (run.scheme.read || run.scheme.name == "yoshida4_kdk")
    throw truth::NotCovered("drag in method " + std::string(run.scheme.name));
  run.acceleration =
      spring_and_damper(truth::number(inputs, "k"), truth::not_negative(inputs, "c"),
                        truth::number(inputs, "m"));
  return run;
}

Run pendulum_run(const Json& inputs) {
  return {.scheme = scheme_of(inputs),
          .acceleration = pendulum_of(truth::positive(inputs, "g"),
                                      truth::positive(inputs, "length")),
          .start = state_of(
              {{truth::number(inputs, "theta0")}, {truth::number(inputs, "omega0")}}),
          .dt = Real(truth::number(inputs, "dt")),
          .n = truth::steps(inputs)};
}

Run convergence_run(const Json& inputs, const Scheme& scheme, long long n) {
  return {.scheme = scheme,
          .acceleration = pendulum_of(1, 1),
          .start = state_of(
              {{truth::number(inputs, "theta0")}, {truth::number(inputs, "omega0")}}),
          .dt = Real(truth::positive(inputs, "T") / static_cast<double>(n)),
          .n = n};
}

Run kepler_run(const Json& inputs) {
  const double nearest = 1 - truth::eccentricity(inputs);
  return {
      .scheme = scheme_of(inputs),
      .acceleration = [](auto x, auto, Real,
                         auto a) { put(a, 0, gravity_towards_origin(1, at(x, 0))); },
      .start = state_of({{nearest, 0, 0}, {0, truth::number(inputs, "v0y"), 0}}),
      .dt = Real(truth::number(inputs, "dt")),
      .n = truth::steps(inputs)};
}

DoublePendulum double_pendulum_of(const Json& inputs) {
  const auto get = [&](const char* name) {
    return Real(truth::positive(inputs, name));
  };
  return {.m1 = get("m1"),
          .m2 = get("m2"),
          .l1 = get("l1"),
          .l2 = get("l2"),
          .g = Real(truth::not_negative(inputs, "g"))};
}

Run double_pendulum_run(const Json& inputs) {
  const double t = truth::not_negative(inputs, "t");
  if (t > 1000) throw InputError("t: must not be above 1000");
  const auto get = [&](const char* name) { return truth::number(inputs, name); };
  return {.scheme = *find_scheme("dopri5"),
          .acceleration = [p = double_pendulum_of(inputs)](
                              auto x, auto v, Real,
                              auto a) { double_pendulum(p, x, v, a); },
          .start = state_of(
              {{get("theta1"), get("theta2")}, {get("omega1"), get("omega2")}}),
          .dt = Real(t),
          .n = 1};
}

Tolerance double_pendulum_tolerance() {
  constexpr Real k_tight = 32 * std::numeric_limits<Real>::epsilon();
  return {.relative = k_tight, .absolute = k_tight, .most_steps = 1'000'000};
}

Integration end_of(const Run& run) {
  Integration now = begin(run.scheme, run.acceleration, run.start, run.dt);
  for (long long i = 0; i < run.n; ++i) advance(now);
  return now;
}

Json invariant_fields(const Json& inputs, const Scheme& scheme, const StepMatrix& m) {
  const double k = truth::positive(inputs, "k");
  const double omega = truth::frequency(inputs);
  const double z = omega * truth::number(inputs, "dt");
  ModifiedEnergy h = modified_energy(m, z);

  // Any multiple is kept, too: of an implicit method the one closest to the energy
  const double scale = scheme.evaluations == 0 ? h.xx + h.vv : 1;
  h = {h.xx / scale, h.xv / scale, h.vv / scale};
  const EnergyRange range = energy_range(h);
  const double x0 = truth::number(inputs, "x0");
  const double v0 = truth::number(inputs, "v0") / omega;
  const double kept = k * (h.xx * x0 * x0 + h.xv * x0 * v0 + h.vv * v0 * v0);
  return {{"coeff_xx", k * h.xx},
          {"coeff_xv", k * h.xv / omega},
          {"coeff_vv", k * h.vv / (omega * omega)},
          {"H_modified", kept},
          {"E0", k * (x0 * x0 + v0 * v0) / 2},
          {"E_lower_bound", kept * range.least},
          {"E_upper_bound", kept * range.most},
          {"effective_omega", omega * frequency_ratio(m, z)},
          {"true_omega", omega}};
}

State state_of(const Place& place) {
  return {.x = {place.x.begin(), place.x.end()},
          .v = {place.v.begin(), place.v.end()},
          .a = std::vector<Real>(place.x.size())};
}

Place place_of(const State& state) {
  return {{state.x.begin(), state.x.end()}, {state.v.begin(), state.v.end()}};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
