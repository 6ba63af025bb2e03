// What single precision may cost in the fields of each kind: see single_error.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "common/physics/dormand_prince.hpp"
#include "common/physics/schemes.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/moving_frame.hpp"
#include "tests/truth/single_error.hpp"

namespace timestep::truth {
namespace {

using Vector = std::vector<double>;
using Fields = Json (*)(const Json& inputs, const Place& end);

struct Reached {
  Place at;
  Ellipsoid error;
};

Reached end_of(const Rounded& rounded) {
  Followed run(rounded);
  for (long long i = 0; i < rounded.run.n; ++i) run.step();
  return {run.at(), run.error()};
}

Json at_the_end(const Json& inputs, const Rounded& rounded, Fields fields) {
  const auto [at, error] = end_of(rounded);
  return spread([&](const Place& place) { return fields(inputs, place); }, at, error);
}

// The largest uncertainty of a number along the run
double most_along(const Rounded& rounded,
                  const std::function<double(const Place&)>& number) {
  const auto field = [&](const Place& at) -> Json { return {{"it", number(at)}}; };
  Followed run(rounded);
  double most = 0;
  for (long long i = 0; i <= rounded.run.n; ++i) {
    if (i > 0) run.step();
    most = std::max(most, spread(field, run.at(), run.error())["it"].get<double>());
  }
  return most;
}

Json constant_acceleration_steps(const Json& inputs) {
  return at_the_end(inputs, {constant_acceleration_run(inputs), true},
                    constant_acceleration_fields);
}

// The matrix of a linear step, on x and v / omega: where it leads from either unit
Reached matrix_of(Run run, double omega) {
  if (run.scheme.read && run.scheme.order == 1) run.scheme = *find_scheme("leapfrog");
  run.n = 1;
  run.start = state_of({{1}, {0}});
  const auto [x, x_error] = end_of({run, true});
  run.start = state_of({{0}, {omega}});
  const auto [v, v_error] = end_of({run, true});
  Reached matrix{{{x.x[0], v.x[0]}, {x.v[0] / omega, v.v[0] / omega}}, {}};
  for (const Place& by : x_error)
    matrix.error.push_back({{by.x[0], 0}, {by.v[0] / omega, 0}});
  for (const Place& by : v_error)
    matrix.error.push_back({{0, by.x[0]}, {0, by.v[0] / omega}});
  return matrix;
}

StepMatrix as_matrix(const Place& m) {
  return {m.x[0], m.x[1], m.v[0], m.v[1]};
}

Json radius_fields(const Place& matrix) {
  const double radius = spectral_radius(as_matrix(matrix));
  return {{"spectral_radius", radius},
          {"energy_factor_per_step_asymptotic", radius * radius}};
}

Json radius_tolerance(const Run& run, double omega) {
  const auto [matrix, error] = matrix_of(run, omega > 0 ? omega : 1);
  return spread(radius_fields, matrix, error);
}

Json oscillator_steps(const Json& inputs) {
  const Run run = oscillator_run(inputs);
  Json tolerance = at_the_end(inputs, {run, true}, oscillator_fields);
  tolerance.update(radius_tolerance(run, frequency(inputs)));
  if (!run.scheme.read) return tolerance;

  // The velocities half a step behind: at the end, and a step later
  const auto behind = [&](const Place& at) -> Json {
    Vector a(1);
    run.acceleration(at.x, at.v, 0, a);
    return {{"v", at.v[0] - a[0] * run.dt / 2}};
  };
  for (const auto& [name, more] : {std::pair{"v_backward", 0}, {"v_half_forward", 1}}) {
    Run longer = run;
    longer.n += more;
    const auto [at, error] = end_of({longer, true});
    tolerance[name] = spread(behind, at, error)["v"];
  }
  return tolerance;
}

Json oscillator_invariant(const Json& inputs) {
  const Run run = oscillator_run(inputs);
  const auto [matrix, matrix_error] = matrix_of(run, frequency(inputs));
  const auto fields = [&](const Place& m) {
    return invariant_fields(inputs, run.scheme, as_matrix(m));
  };
  Json tolerance = spread(fields, matrix, matrix_error);

  // An extreme over the run is as uncertain as the most uncertain energy
  const double most = most_along(
      {run, true}, [&](const Place& at) { return oscillator_energy(inputs, at); });
  tolerance["E_min_over_run"] = tolerance["E_max_over_run"] = most;
  return tolerance;
}

Run unit_oscillator(const Scheme& scheme, double z) {
  return {.scheme = scheme,
          .acceleration = [](auto x, auto, double, auto a) { a[0] = -x[0]; },
          .start = {{1}, {0}, {0}},
          .dt = z,
          .n = 1};
}

Json growth_factor(const Json& inputs) {
  const double z = not_negative(inputs, "omega_dt");
  return radius_tolerance(unit_oscillator(scheme_of(inputs), z), 1);
}

// Where the criterion crosses its limit: its error over its slope
Json limit_of_stability(const Json& inputs) {
  const Scheme scheme = scheme_of(inputs);
  const double limit = stability_limit(scheme);
  if (limit == 0 || std::isinf(limit)) return Json::object();
  const auto criterion = [&](const Place& matrix) -> Json {
    const StepMatrix m = as_matrix(matrix);
    return {{"it", scheme.symplectic ? m.xx + m.vv : spectral_radius(m)}};
  };
  const auto [at, error] = matrix_of(unit_oscillator(scheme, limit), 1);
  constexpr double h = 1e-4;
  const Place above = matrix_of(unit_oscillator(scheme, limit + h), 1).at;
  const Place below = matrix_of(unit_oscillator(scheme, limit - h), 1).at;
  const double rise =
      criterion(above)["it"].get<double>() - criterion(below)["it"].get<double>();
  return {{"omega_dt_max", spread(criterion, at, error)["it"].get<double>()
                               / std::abs(rise / (2 * h))}};
}

Json damped_oscillator_steps(const Json& inputs) {
  const Run run = damped_oscillator_run(inputs);
  Json tolerance = at_the_end(inputs, {run, true}, damped_oscillator_fields);
  tolerance.update(radius_tolerance(run, frequency(inputs)));
  return tolerance;
}

Json pendulum_steps(const Json& inputs) {
  return at_the_end(inputs, {pendulum_run(inputs), false}, pendulum_fields);
}

// The errors on the ladder as one place: theta's as its x, omega's as its v
Reached errors_on_ladder(const Json& inputs) {
  const std::vector<long long> steps = ladder(inputs);
  const FinePlace exact = convergence_reference(inputs);
  const Vector none(steps.size());
  Reached all{{none, none}, {}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto [at, error] =
        end_of({.run = convergence_run(inputs, scheme_of(inputs), steps[i]),
                .linear = false,
                .in_frame = true});
    all.at.x[i] = at.x[0] - exact.high.x[0];
    all.at.v[i] = at.v[0] - exact.high.v[0];

    // The runs are uncertain one by one
    for (const Place& by : error) {
      Place& alone = all.error.emplace_back(Place{none, none});
      alone.x[i] = by.x[0];
      alone.v[i] = by.v[0];
    }
  }
  return all;
}

Json convergence_order(const Json& inputs) {
  const auto fields = [&](const Place& errors) {
    std::vector<Place> each;
    for (std::size_t i = 0; i < errors.x.size(); ++i)
      each.push_back({{errors.x[i]}, {errors.v[i]}});
    return convergence_fields(inputs, each);
  };
  const auto [errors, uncertain] = errors_on_ladder(inputs);
  Json tolerance = spread(fields, errors, uncertain);

  // A quotient of errors that may as well be 0 can be anything
  const auto may_be_0 = [&errors = errors, &uncertain = uncertain](std::size_t i) {
    double size = 0;
    for (const Place& by : uncertain) size += std::hypot(by.x[i], by.v[i]);
    return size >= std::hypot(errors.x[i], errors.v[i]);
  };
  for (std::size_t i = 1; i < errors.x.size(); ++i)
    if (may_be_0(i - 1) || may_be_0(i))
      tolerance["observed_order"][i - 1] = std::numeric_limits<double>::infinity();
  return tolerance;
}

Json kepler_steps(const Json& inputs) {
  const Rounded rounded{kepler_run(inputs), false};
  Json tolerance = at_the_end(inputs, rounded, kepler_fields);
  tolerance["energy_relative_error_max"] = most_along(
      rounded, [&](const Place& at) { return kepler_energy_error(inputs, at); });
  return tolerance;
}

Json double_pendulum_reference(const Json& inputs) {
  // As many steps as single precision's tolerance asks for, each of which may be wrong
  // by that tolerance: 64 u of 1 + |x|
  Run run = double_pendulum_run(inputs);
  constexpr double k_tolerance = 0x1p-18;
  State reached = run.start;
  const AdaptiveCost cost =
      dormand_prince(reached, run.acceleration, 0, run.dt, {k_tolerance, k_tolerance});
  run.n = std::max(1LL, 2 * (cost.accepted + cost.rejected));
  run.dt /= double(run.n);
  const DoublePendulum p = double_pendulum_of(inputs);
  const auto fields = [&](const Place& at) -> Json {
    return {{"theta1", at.x[0]},
            {"theta2", at.x[1]},
            {"omega1", at.v[0]},
            {"omega2", at.v[1]},
            {"energy", energy(p, at.x, at.v)}};
  };
  const auto [at, error] =
      end_of({.run = run, .linear = false, .solver_error = 2 * 64});
  Json tolerance = spread(fields, at, error);

  // Energy is a sum of terms, of up to 8 roundings each
  const double deepest = (p.m1 + p.m2) * p.g * p.l1 + p.m2 * p.g * p.l2;
  const double terms = 2 * deepest + std::abs(energy(p, at.x, at.v));
  tolerance["energy"] = tolerance["energy"].get<double>() + 8 * 0x1p-24 * terms;
  return tolerance;
}

}  // namespace

std::span<const Kind> single_tolerances() {
  static constexpr std::array<Kind, 10> all{{
      {"constant_acceleration_steps", constant_acceleration_steps},
      {"oscillator_steps", oscillator_steps},
      {"oscillator_invariant", oscillator_invariant},
      {"growth_factor", growth_factor},
      {"stability_limit", limit_of_stability},
      {"damped_oscillator_steps", damped_oscillator_steps},
      {"pendulum_steps", pendulum_steps},
      {"convergence_order", convergence_order},
      {"kepler_steps", kepler_steps},
      {"double_pendulum_reference", double_pendulum_reference},
  }};
  return all;
}

}  // namespace timestep::truth
