// The kinds of chapter 2 about pendulums, orbits and springs, computed through the code
// in common/physics.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/physics/exact_orbit.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "tests/truth/inputs.hpp"
#include "tests/truth/moving_frame.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::number;
using truth::Place;
using truth::positive;

Json pendulum_exact(const Json& inputs) {
  const exact::Coordinate start{number(inputs, "theta0"), number(inputs, "omega0")};
  const double omega0 = std::sqrt(positive(inputs, "g") / positive(inputs, "length"));
  const auto end = exact::pendulum(start, omega0, number(inputs, "t"));
  return {{"theta", end.x},
          {"omega", end.v},
          {"period", exact::pendulum_period(start, omega0)},
          {"small_angle_period", 2 * std::numbers::pi / omega0}};
}

Json pendulum_steps(const Json& inputs) {
  return truth::pendulum_fields(inputs, place_of(read(end_of(pendulum_run(inputs)))));
}

// How far a run ends from the exact end. Where T / n is rounded, it ends beside T, too.
Place convergence_error(const Json& inputs, const Run& run,
                        const truth::FinePlace& exact) {
  const auto& [high, low] = fine_end_of(run).now;
  const double theta = high.x[0] - exact.high.x[0] + (low.x[0] - exact.low.x[0]);
  const double omega = high.v[0] - exact.high.v[0] + (low.v[0] - exact.low.v[0]);
  const double late = std::fma(run.n, run.dt, -number(inputs, "T"));
  return {{theta - late * high.v[0]}, {omega + late * std::sin(high.x[0])}};
}

Json convergence_order(const Json& inputs) {
  const Scheme scheme = scheme_of(inputs);
  const auto exact = double_precision::convergence_reference(inputs);
  std::vector<Place> errors;
  for (const long long n : truth::ladder(inputs))
    errors.push_back(
        convergence_error(inputs, convergence_run(inputs, scheme, n), exact));
  Json fields = truth::convergence_fields(inputs, errors);
  fields["theoretical_order"] = scheme.order;
  return fields;
}

Json kepler_exact(const Json& inputs) {
  const double e = truth::eccentricity(inputs);
  const double t = number(inputs, "t");
  const exact::Motion now = exact::orbit(1, 1, e, t);
  const exact::OrbitElements kept = exact::elements(1, now);
  return {{"x", {now.x.x, now.x.y}},
          {"v", {now.v.x, now.v.y}},
          {"energy", kept.energy},
          {"angular_momentum", kept.angular_momentum},
          {"eccentric_anomaly", exact::eccentric_anomaly(t, e)},
          {"period", 2 * std::numbers::pi}};
}

Json kepler_steps(const Json& inputs) {
  const Run run = kepler_run(inputs);
  Integration now = begin(run.scheme, run.acceleration, run.start, run.dt);
  double worst = 0;
  for (long long i = 0; i < run.n; ++i) {
    advance(now);
    const double error = truth::kepler_energy_error(inputs, place_of(read(now)));
    worst = std::max(worst, std::abs(error));
  }
  Json fields = truth::kepler_fields(inputs, place_of(read(now)));
  fields["energy_relative_error_max"] = worst;
  return fields;
}

Json double_pendulum_reference(const Json& inputs) {
  const Run run = double_pendulum_run(inputs);
  State now = run.start;
  dormand_prince(now, run.acceleration, 0, run.dt, double_pendulum_tolerance());
  return {{"theta1", now.x[0]},
          {"theta2", now.x[1]},
          {"omega1", now.v[0]},
          {"omega2", now.v[1]},
          {"energy", energy(double_pendulum_of(inputs), now.x, now.v)}};
}

Json spring_two_body(const Json& inputs) {
  const double m1 = positive(inputs, "m1");
  const double m2 = positive(inputs, "m2");
  const double k = positive(inputs, "k");
  const auto [first, second] = exact::spring_between(
      {{number(inputs, "x1"), number(inputs, "v1")},
       {number(inputs, "x2"), number(inputs, "v2")}},
      m1, m2, k, number(inputs, "rest_length"), number(inputs, "t"));
  return {{"x1", first.x},
          {"x2", second.x},
          {"v1", first.v},
          {"v2", second.v},
          {"angular_frequency", std::sqrt(k * (m1 + m2) / (m1 * m2))}};
}

}  // namespace

std::span<const Kind> truth_kinds_02_motions() {
  static constexpr std::array<Kind, 7> kinds{{
      {"pendulum_exact", pendulum_exact},
      {"pendulum_steps", pendulum_steps},
      {"convergence_order", convergence_order},
      {"kepler_exact", kepler_exact},
      {"kepler_steps", kepler_steps},
      {"double_pendulum_reference", double_pendulum_reference},
      {"spring_two_body", spring_two_body},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
