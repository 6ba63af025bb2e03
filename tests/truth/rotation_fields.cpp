#include "tests/truth/rotation_fields.hpp"

#include <algorithm>
#include <cmath>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_free_top.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::truth {
namespace {

using exact::Turning;
using glm::dquat;
using glm::dvec3;

Json json(const dquat& q) {
  return {q.w, q.x, q.y, q.z};
}

Json json(const dvec3& v) {
  return {v.x, v.y, v.z};
}

Turning turning(const Place& at) {
  return {dquat(at.x[0], at.x[1], at.x[2], at.x[3]), dvec3(at.v[0], at.v[1], at.v[2])};
}

dvec3 inertia(const Json& inputs) {
  const dvec3 I = vector(inputs, "inertia");
  if (!(std::min({I.x, I.y, I.z}) > 0)) throw InputError("inertia: must be above 0");
  return I;
}

dvec3 angular_momentum(const Json& inputs, const Turning& at) {
  return exact::angular_momentum(at, inertia(inputs));
}

Turning start(const Json& inputs) {
  return {quaternion(inputs, "q0"), vector(inputs, "omega_body0")};
}

Turning exactly(const Json& inputs, double t) {
  return exact::free_top(inertia(inputs), start(inputs), t);
}

}  // namespace

dquat quaternion(const Json& inputs, const char* name) {
  const Json& q = inputs.at(name);
  const auto is_number = [](const Json& part) { return part.is_number(); };
  if (!q.is_array() || q.size() != 4 || !std::ranges::all_of(q, is_number))
    throw InputError(std::string(name) + ": must be four numbers");
  const dquat read(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                   q[3].get<double>());
  if (!(std::abs(glm::length(read) - 1) < 1e-6))
    throw InputError(std::string(name) + ": must be of length one");
  return read;
}

double energy_ratio(const Json& inputs, const Place& at) {
  const Turning before{dquat(1, 0, 0, 0), vector(inputs, "omega_body0")};
  const dvec3 I = inertia(inputs);
  return exact::rotational_energy(turning(at), I) / exact::rotational_energy(before, I);
}

Json rotation_fields(const Json& inputs, const Place& end) {
  const Turning now = turning(end);
  const double t = number(inputs, "dt") * static_cast<double>(steps(inputs));
  const Turning exact = exactly(inputs, t);
  const dvec3 L = angular_momentum(inputs, start(inputs));
  const dvec3 gained = angular_momentum(inputs, now) - L;
  return {{"q", json(now.q)},
          {"omega_body", json(now.omega)},
          {"q_exact", json(exact.q)},
          {"omega_body_exact", json(exact.omega)},
          {"attitude_error_angle", exact::angle_between(exact.q, now.q)},
          {"omega_error", glm::length(now.omega - exact.omega)},
          {"energy_relative_error_end", energy_ratio(inputs, end) - 1},
          {"L_world_relative_error", glm::length(gained) / glm::length(L)}};
}

Json listing3_fields(const Json& inputs, const Place& end) {
  const Turning now = turning(end);
  const Turning exact = exactly(inputs, number(inputs, "t"));
  const dvec3 L0 = angular_momentum(inputs, start(inputs));
  const dvec3 L = angular_momentum(inputs, now);

  // L goes round omega; it is farthest from its start on the other side
  const dvec3 omega = start(inputs).q * start(inputs).omega;
  const double between = exact::angle_between(omega, L0);
  return {{"q_listing3", json(now.q)},
          {"q_exact", json(exact.q)},
          {"attitude_error_angle", exact::angle_between(exact.q, now.q)},
          {"L_error_relative", glm::length(L - L0) / glm::length(L0)},
          {"L_error_relative_max_over_time", 2 * std::sin(between)},
          {"L_direction_error_angle", exact::angle_between(L0, L)},
          {"energy_error_relative", energy_ratio(inputs, end) - 1},
          {"angle_between_omega_and_L", between}};
}

Json gyro_fields(const Json& inputs, const Place& end) {
  const dvec3 I = inertia(inputs);
  const dvec3 omega = turning(end).omega;
  const double L0 = glm::length(I * vector(inputs, "omega_body0"));
  return {{"omega_body", json(omega)},
          {"energy_ratio", energy_ratio(inputs, end)},
          {"L_ratio", glm::length(I * omega) / L0}};
}

Json quaternion_drift_fields(const Json& inputs, const Place& end) {
  const double omega = glm::length(vector(inputs, "omega"));
  const double z = omega * number(inputs, "dt");
  const auto n = static_cast<double>(steps(inputs));

  // A step makes q longer by sqrt(1 + z²/4)
  const double log_norm = n * std::log1p(z * z / 4) / 2;
  const dvec3 half = vector(inputs, "omega") * (number(inputs, "dt") * n / 2);
  const double angle = glm::length(half);
  const dvec3 vec = angle > 0 ? std::sin(angle) / angle * half : dvec3(0);
  return {{"norm_without_normalisation", std::exp(log_norm)},
          {"log10_norm", log_norm / std::log(10.0)},
          {"angle_true", n * z},
          {"q_normalised_each_step", json(turning(end).q)},
          {"q_exact", json(dquat(std::cos(angle), vec))}};
}

Json turned_by_steps(const Json& inputs, const Place& first) {
  const double z = glm::length(vector(inputs, "omega")) * number(inputs, "dt");
  const auto n = static_cast<double>(steps(inputs));
  const double angle = exact::angle_between(dquat(1, 0, 0, 0), turning(first).q);
  return {{"angle_per_step", angle},
          {"angle_after_n_steps", n * angle},
          {"angle_error", n * (angle - z)},
          {"relative_rate_error", angle / z - 1}};
}

double attitude_error(const Json& inputs, const Place& end) {
  return exact::angle_between(exactly(inputs, number(inputs, "T")).q, turning(end).q);
}

Json rotation_order_fields(const Json& inputs, const std::vector<double>& errors) {
  const std::vector<long long> n = ladder(inputs);
  std::vector<double> order;
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double finer = static_cast<double>(n[i]) / static_cast<double>(n[i - 1]);
    order.push_back(std::log(errors[i - 1] / errors[i]) / std::log(finer));
  }
  return {{"attitude_errors", errors}, {"observed_order", order}};
}

}  // namespace timestep::truth
