// The kinds of chapter 3 that closed forms answer, computed through the exact motions
// in common/physics: in double in both precisions.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_cue_ball.hpp"
#include "common/physics/exact_free_top.hpp"
#include "common/physics/exact_heavy_top.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::not_negative;
using truth::number;
using truth::positive;

Json json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

Json json(const glm::dquat& q) {
  return {q.w, q.x, q.y, q.z};
}

// What is infinite, or has no value, is null
Json json(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

glm::dvec3 moments(const Json& inputs) {
  const glm::dvec3 I = truth::vector(inputs, "inertia");
  if (!(std::min({I.x, I.y, I.z}) > 0))
    throw InputError("inertia: must be three numbers above 0");
  return I;
}

exact::Turning start_of(const Json& inputs) {
  const Json& q0 = inputs.at("q0");
  const auto is_number = [](const Json& part) { return part.is_number(); };
  if (!q0.is_array() || q0.size() != 4 || !std::ranges::all_of(q0, is_number))
    throw InputError("q0: must be four numbers");
  const glm::dquat q{q0[0].get<double>(), q0[1].get<double>(), q0[2].get<double>(),
                     q0[3].get<double>()};
  if (!(glm::length(q) > 0)) throw InputError("q0: must not be 0");
  return {glm::normalize(q), truth::vector(inputs, "omega_body0")};
}

Json turning_fields(const exact::Turning& now) {
  return {{"q", json(now.q)},
          {"omega_body", json(now.omega)},
          {"omega_world", json(now.q * now.omega)}};
}

Json free_fields(const glm::dvec3& I, const Json& inputs) {
  const exact::Turning start = start_of(inputs);
  Json fields = turning_fields(exact::free_top(I, start, number(inputs, "t")));
  const glm::dvec3 L = I * start.omega;
  fields["L_world"] = json(start.q * L);
  fields["energy"] = glm::dot(L, start.omega) / 2;
  return fields;
}

Json asymmetric_top_free(const Json& inputs) {
  const glm::dvec3 I = moments(inputs);
  Json fields = free_fields(I, inputs);
  const auto motion = exact::free_top_motion(I, truth::vector(inputs, "omega_body0"));
  fields["elliptic_m"] = motion.m;
  fields["omega_body_period"] = json(motion.period);
  fields["circulating_axis"] = motion.circulating_axis;
  return fields;
}

Json symmetric_top_free(const Json& inputs) {
  const double I1 = positive(inputs, "I1");
  const double I3 = positive(inputs, "I3");
  const glm::dvec3 omega = truth::vector(inputs, "omega_body0");
  const double across = I1 * std::hypot(omega.x, omega.y);
  const double L3 = I3 * omega.z;
  Json fields = free_fields({I1, I1, I3}, inputs);
  fields["body_precession_rate"] = (I3 - I1) / I1 * omega.z;
  fields["space_precession_rate"] = std::hypot(across, L3) / I1;
  fields["nutation_angle"] = std::atan2(across, L3);
  return fields;
}

Json flip_period(const Json& inputs) {
  const glm::dvec3 I = moments(inputs);
  std::array<glm::length_t, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](glm::length_t i) { return I[i]; });
  const auto [least, middle, most] = order;
  const double axis = number(inputs, "axis");
  if (axis != least && axis != most)
    throw InputError("axis: must be the one of the least or of the largest moment");

  glm::dvec3 omega{0};
  omega[middle] = number(inputs, "spin");
  omega[axis == least ? least : most] = number(inputs, "perturbation");
  const double interval = exact::flip_interval(I, omega);
  const double growth =
      std::sqrt((I[middle] - I[least]) / I[least] * ((I[most] - I[middle]) / I[most]));
  return {{"omega_body0", json(omega)},
          {"flip_interval", json(interval)},
          {"full_period", json(2 * interval)},
          {"elliptic_m", exact::free_top_motion(I, omega).m},
          {"first_zero_crossing_of_omega2", json(interval / 2)},
          {"linear_growth_rate", std::abs(omega[middle]) * growth}};
}

exact::HeavyTop heavy_top_of(const Json& inputs) {
  return {.I1 = positive(inputs, "I1_pivot"),
          .I3 = positive(inputs, "I3"),
          .mass = positive(inputs, "mass"),
          .g = not_negative(inputs, "g"),
          .l = not_negative(inputs, "l")};
}

Json heavy_top_steady(const Json& inputs) {
  const exact::HeavyTop top = heavy_top_of(inputs);
  const double theta = number(inputs, "theta");
  const double omega3 = number(inputs, "omega3");
  const double weight = top.mass * top.g * top.l;
  Json fields{{"discriminant", exact::steady_discriminant(top, theta, omega3)},
              {"min_omega3_for_steady", exact::least_steady_spin(top, theta)},
              {"min_omega3_sleeping", exact::least_steady_spin(top, 0)},
              {"gyroscope_estimate_mgl_over_I3w3", json(weight / (top.I3 * omega3))}};
  if (const auto rates = exact::steady_precession(top, theta, omega3)) {
    fields["precession_slow"] = rates->slow;
    fields["precession_fast"] = json(rates->fast);
  }
  return fields;
}

Json heavy_top_motion(const Json& inputs) {
  const exact::HeavyTop top = heavy_top_of(inputs);
  const exact::HeavyTopStart start{number(inputs, "theta0"), number(inputs, "phi_dot0"),
                                   number(inputs, "omega3")};
  if (!(start.theta >= 0 && start.theta <= std::numbers::pi))
    throw InputError("theta0: must be from 0 to pi");
  const auto now = exact::heavy_top(top, start, number(inputs, "t"));
  const auto before = exact::heavy_top(top, start, 0);
  const exact::Turning first = exact::turning(before, start.omega3);
  const exact::Nutation nods = exact::nutation(top, start);
  const double across = start.phi_rate * std::sin(start.theta);
  Json fields = turning_fields(exact::turning(now, start.omega3));
  fields.update(
      {{"theta", now.theta},
       {"phi", now.phi},
       {"psi", now.psi},
       {"theta_dot", now.theta_rate},
       {"phi_dot", now.phi_rate},
       {"nutation_period", json(nods.period)},
       {"theta_min", nods.theta_min},
       {"theta_max", nods.theta_max},
       {"omega_body0", json(first.omega)},
       {"q0", json(first.q)},
       {"I1_about_com", top.I1 - top.mass * top.l * top.l},
       {"Lz", top.I1 * across * std::sin(start.theta)
                  + top.I3 * start.omega3 * std::cos(start.theta)},
       {"energy", (top.I1 * across * across + top.I3 * start.omega3 * start.omega3) / 2
                      + top.mass * top.g * top.l * std::cos(start.theta)}});
  return fields;
}

Json cue_strike(const Json& inputs) {
  const exact::Ball ball{.mass = positive(inputs, "mass"),
                         .radius = positive(inputs, "radius"),
                         .k = 0.4,
                         .mu = not_negative(inputs, "mu"),
                         .g = not_negative(inputs, "g")};
  const auto start = exact::struck(ball, number(inputs, "impulse"),
                                   number(inputs, "height_above_centre"), 0);
  const double rolling = exact::time_until_rolling(ball, start);
  const double speed = exact::slide_then_roll(ball, start, rolling).v.x;
  return {{"v0", start.v.x},
          {"topspin0", start.omega.y},
          {"final_speed", speed},
          {"rolling_time", json(rolling)},
          {"natural_roll_height", exact::rolling_height(ball)},
          {"final_over_initial", json(speed / start.v.x)}};
}

}  // namespace

std::span<const Kind> truth_kinds_03_exact() {
  static constexpr std::array<Kind, 6> kinds{{
      {"asymmetric_top_free", asymmetric_top_free},
      {"symmetric_top_free", symmetric_top_free},
      {"flip_period", flip_period},
      {"heavy_top_steady", heavy_top_steady},
      {"heavy_top_motion", heavy_top_motion},
      {"cue_strike", cue_strike},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
