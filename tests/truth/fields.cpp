#include "tests/truth/fields.hpp"

#include <cmath>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_orbit.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::truth {
namespace {

Json json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

glm::dvec3 vec3(const std::vector<double>& v) {
  return {v[0], v[1], v[2]};
}

double duration(const Json& inputs) {
  return number(inputs, "dt") * static_cast<double>(steps(inputs));
}

exact::Motion kepler_start(const Json& inputs) {
  return {{1 - eccentricity(inputs), 0, 0}, {0, number(inputs, "v0y"), 0}};
}

// In units of m length²; 1 - cos theta without cancellation
double pendulum_energy(const Json& inputs, double theta, double omega) {
  const double s = std::sin(theta / 2);
  return omega * omega / 2 + 2 * number(inputs, "g") / number(inputs, "length") * s * s;
}

}  // namespace

Place rounded(const FinePlace& place) {
  Place all = place.high;
  for (std::size_t i = 0; i < all.x.size(); ++i) {
    all.x[i] += place.low.x[i];
    all.v[i] += place.low.v[i];
  }
  return all;
}

Json constant_acceleration_fields(const Json& inputs, const Place& end) {
  const exact::Motion e =
      exact::constant_acceleration({vector(inputs, "x0"), vector(inputs, "v0")},
                                   vector(inputs, "a"), duration(inputs));
  return {{"x", end.x},
          {"v", end.v},
          {"x_exact", json(e.x)},
          {"x_error", json(vec3(end.x) - e.x)}};
}

double frequency(const Json& inputs) {
  return std::sqrt(not_negative(inputs, "k") / positive(inputs, "m"));
}

double oscillator_energy(const Json& inputs, const Place& at) {
  return (number(inputs, "m") * at.v[0] * at.v[0]
          + number(inputs, "k") * at.x[0] * at.x[0])
         / 2;
}

Json damped_oscillator_fields(const Json& inputs, const Place& end) {
  const double gamma =
      inputs.contains("c") ? number(inputs, "c") / (2 * number(inputs, "m")) : 0;
  const auto e = exact::oscillator({number(inputs, "x0"), number(inputs, "v0")},
                                   frequency(inputs), gamma, duration(inputs));
  return {{"x", end.x[0]}, {"v", end.v[0]}, {"x_exact", e.x}, {"v_exact", e.v}};
}

Json oscillator_fields(const Json& inputs, const Place& end) {
  Json fields = damped_oscillator_fields(inputs, end);
  fields["E"] = oscillator_energy(inputs, end);
  fields["E0"] =
      oscillator_energy(inputs, {{number(inputs, "x0")}, {number(inputs, "v0")}});
  return fields;
}

Json pendulum_fields(const Json& inputs, const Place& end) {
  const exact::Coordinate start{number(inputs, "theta0"), number(inputs, "omega0")};
  const double omega0 = std::sqrt(positive(inputs, "g") / positive(inputs, "length"));
  const auto e = exact::pendulum(start, omega0, duration(inputs));
  const double energy = pendulum_energy(inputs, start.x, start.v);
  return {{"theta", end.x[0]},
          {"omega", end.v[0]},
          {"theta_exact", e.x},
          {"omega_exact", e.v},
          {"energy_relative_error",
           (pendulum_energy(inputs, end.x[0], end.v[0]) - energy) / energy}};
}

double eccentricity(const Json& inputs) {
  const double e = not_negative(inputs, "e");
  if (!(e < 1)) throw InputError("e: must be below 1");
  return e;
}

double kepler_energy_error(const Json& inputs, const Place& at) {
  const double energy = exact::elements(1, kepler_start(inputs)).energy;
  return exact::elements(1, {vec3(at.x), vec3(at.v)}).energy / energy - 1;
}

Json kepler_fields(const Json& inputs, const Place& end) {
  const auto start = exact::elements(1, kepler_start(inputs));
  const auto now = exact::elements(1, {vec3(end.x), vec3(end.v)});
  return {{"x", {end.x[0], end.x[1]}},
          {"v", {end.v[0], end.v[1]}},
          {"energy_relative_error_end", kepler_energy_error(inputs, end)},
          {"angular_momentum_relative_error",
           now.angular_momentum / start.angular_momentum - 1},
          {"apsis_rotation_total", now.pericentre},
          {"apsis_rotation_per_orbit", now.pericentre / positive(inputs, "orbits")},
          {"eccentricity_end", now.eccentricity}};
}

Json convergence_fields(const Json& inputs, const std::vector<Place>& errors) {
  const std::vector<long long> n = ladder(inputs);
  std::vector<double> theta, omega, state, order;
  for (const auto& [x, v] : errors) {
    theta.push_back(std::abs(x[0]));
    omega.push_back(std::abs(v[0]));
    state.push_back(std::hypot(x[0], v[0]));
  }
  for (std::size_t i = 1; i < state.size(); ++i) {
    const double finer = static_cast<double>(n[i]) / static_cast<double>(n[i - 1]);
    order.push_back(std::log(state[i - 1] / state[i]) / std::log(finer));
  }
  return {{"theta_errors", theta},
          {"omega_errors", omega},
          {"state_errors", state},
          {"observed_order", order}};
}

}  // namespace timestep::truth
