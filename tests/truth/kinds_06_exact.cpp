// The kinds of chapter 6 that closed forms of impacts answer, computed through
// common/physics/exact_*: in double in both precisions.
#include <algorithm>
#include <array>
#include <cmath>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_bounce.hpp"
#include "common/physics/exact_impact.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::not_negative;
using truth::number;
using truth::positive;

// What is infinite, or has no value, is null
Json json(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json json(const glm::dvec2& v) {
  return {json(v.x), json(v.y)};
}

glm::dvec2 plane_vector(const Json& inputs, const char* name) {
  const std::vector<double> v = truth::numbers(inputs, name);
  if (v.size() != 2) throw InputError(std::string(name) + ": must be two numbers");
  return {v[0], v[1]};
}

// The files' y is up; a table's z is: a quarter turn about x
glm::dvec3 on_table(const glm::dvec3& v) {
  return {v.x, -v.z, v.y};
}

Json from_table(const glm::dvec3& v) {
  return {v.x, v.z, -v.y};
}

double restitution(const Json& inputs) {
  return truth::between(inputs, "restitution", 0, 1);
}

Json bouncing_ball(const Json& inputs) {
  const exact::BouncingBall ball{positive(inputs, "height"), restitution(inputs),
                                 positive(inputs, "g")};
  std::vector<double> heights, times, speeds;
  const int bounces = truth::count(inputs, "bounces");
  for (int n = 1; n <= bounces; ++n) {
    heights.push_back(exact::apex_height(ball, n));
    times.push_back(exact::impact_time(ball, n));
    speeds.push_back(exact::rebound_speed(ball, n));
  }
  return {{"first_impact_time", exact::impact_time(ball, 1)},
          {"apex_heights", heights},
          {"impact_times", times},
          {"rebound_speeds", speeds},
          {"zeno_time", json(exact::rest_time(ball))},
          {"total_distance", json(exact::total_distance(ball))}};
}

Json stacked_drop(const Json& inputs) {
  const double height = not_negative(inputs, "height");
  const double g = positive(inputs, "g");
  const std::vector<double> masses = truth::positive_numbers(inputs, "masses");
  const auto v =
      exact::dropped_stack(masses, std::sqrt(2 * g * height), restitution(inputs));
  const double rebound = v.back() * v.back() / (2 * g);
  return {{"velocities_after", v},
          {"top_rebound_height", rebound},
          {"height_ratio", json(rebound / height)}};
}

// Balls in a row, and what an impact changes
struct Row {
  std::vector<double> masses, velocities;
  double e;

  explicit Row(const Json& inputs)
      : masses(truth::positive_numbers(inputs, "masses")),
        velocities(truth::numbers(inputs, "velocities")),
        e(restitution(inputs)) {
    if (masses.size() != velocities.size())
      throw InputError("velocities: must be as many as the masses");
  }

  double momentum(const std::vector<double>& v) const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += masses[i] * v[i];
    return sum;
  }

  double energy(const std::vector<double>& v) const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += masses[i] * v[i] * v[i] / 2;
    return sum;
  }

  Json energy_ratio(const std::vector<double>& after) const {
    return json(energy(after) / energy(velocities));
  }
};

Json newton_cradle(const Json& inputs) {
  const Row row(inputs);
  const auto [after, impacts] = exact::pair_impacts(row.masses, row.velocities, row.e);
  return {{"velocities", after},
          {"pair_impacts", impacts},
          {"momentum", row.momentum(after)},
          {"energy_ratio", row.energy_ratio(after)}};
}

Json simultaneous_line_impact(const Json& inputs) {
  const Row row(inputs);
  const auto [after, impulses] = exact::row_impact(row.masses, row.velocities, row.e);
  return {{"velocities", after},
          {"impulses", impulses},
          {"energy_ratio", row.energy_ratio(after)}};
}

Json penalty_bounce(const Json& inputs) {
  const exact::PenaltyContact contact{positive(inputs, "mass"), positive(inputs, "k"),
                                      not_negative(inputs, "c")};
  const auto no_pull = exact::penalty_bounce(contact);
  const auto restored = exact::sticky_penalty_bounce(contact);
  return {{"max_depth", exact::penalty_depth(contact, not_negative(inputs, "v"))},
          {"time_of_max_depth", exact::penalty_turning_time(contact)},
          {"contact_time_spring_restored", json(restored.time)},
          {"restitution_spring_restored", restored.restitution},
          {"contact_time_no_pull", no_pull.time},
          {"restitution_no_pull", no_pull.restitution},
          {"steps_inside_contact_at_60Hz", json(60 * restored.time)}};
}

Json disc_collision(const Json& inputs) {
  const auto disc = [&](const char* m, const char* r, const char* x, const char* v) {
    return exact::Disc{positive(inputs, m), not_negative(inputs, r),
                       plane_vector(inputs, x), plane_vector(inputs, v)};
  };
  const auto impact = exact::disc_impact(
      disc("m1", "r1", "x1", "v1"), disc("m2", "r2", "x2", "v2"), restitution(inputs));
  if (!impact) return {{"hit", false}};
  return {{"hit", true},
          {"time", impact->time},
          {"normal", json(impact->normal)},
          {"impulse", impact->impulse},
          {"v1", json(impact->first.v)},
          {"v2", json(impact->second.v)},
          {"x1_at_impact", json(impact->first.x)},
          {"x2_at_impact", json(impact->second.x)}};
}

double energy(const exact::Ball& ball, const exact::BallMotion& at) {
  const double I = ball.k * ball.mass * ball.radius * ball.radius;
  return (ball.mass * glm::dot(at.v, at.v) + I * glm::dot(at.omega, at.omega)) / 2;
}

Json sphere_bounce(const Json& inputs) {
  const exact::Ball ball{.mass = positive(inputs, "mass"),
                         .radius = positive(inputs, "radius"),
                         .k = positive(inputs, "inertia_factor"),
                         .mu = not_negative(inputs, "mu"),
                         .g = 0};
  const exact::BallMotion before{{},
                                 on_table(truth::vector(inputs, "velocity")),
                                 on_table(truth::vector(inputs, "omega"))};
  if (!(before.v.z < 0)) throw InputError("velocity: must point down, along -y");
  const auto [impulse, after] = exact::bounced(ball, restitution(inputs), before);
  return {{"velocity", from_table(after.v)},
          {"omega", from_table(after.omega)},
          {"mode", impulse.slip == exact::Slip::sticks ? "stick" : "slide"},
          {"impulse", from_table(impulse.j)},
          {"energy_ratio", energy(ball, after) / energy(ball, before)}};
}

Json slide_to_roll(const Json& inputs) {
  const exact::Ball ball{.mass = 1,
                         .radius = positive(inputs, "radius"),
                         .k = positive(inputs, "inertia_factor"),
                         .mu = not_negative(inputs, "mu"),
                         .g = positive(inputs, "g")};
  const exact::BallMotion start{{0, 0, 0},
                                on_table(truth::vector(inputs, "velocity")),
                                on_table(truth::vector(inputs, "omega"))};
  const double rolling = exact::time_until_rolling(ball, start);
  Json fields{{"rolling_time", json(rolling)},
              {"slip_speed_initial", glm::length(exact::slip(ball, start))}};
  if (!std::isfinite(rolling)) return fields;
  const auto [x, v, omega] = exact::slide_then_roll(ball, start, rolling);
  fields["velocity_at_rolling"] = from_table(v);
  fields["omega_at_rolling"] = from_table(omega);
  fields["displacement_at_rolling"] = from_table(x);
  return fields;
}

Json box_edge_catch(const Json& inputs) {
  const exact::FallingBox box{positive(inputs, "mass"), positive(inputs, "width"),
                              positive(inputs, "height"), number(inputs, "tilt"),
                              positive(inputs, "speed")};
  const double I = box.mass * (box.width * box.width + box.height * box.height) / 12;
  const auto energy_ratio = [&](const exact::BoxImpact& after) {
    const double energy =
        box.mass * glm::dot(after.v, after.v) + I * after.omega * after.omega;
    return energy / (box.mass * box.speed * box.speed);
  };
  const glm::dvec2 arm = exact::lowest_corner(box);
  const auto smooth = exact::corner_bounces(box, restitution(inputs));
  const auto catches = exact::corner_catches(box);
  return {{"contact_arm", json(arm)},
          {"impulse", smooth.impulse.y},
          {"vy", smooth.v.y},
          {"omega", smooth.omega},
          {"energy_ratio", energy_ratio(smooth)},
          {"corner_normal_velocity_after", smooth.v.y + smooth.omega * arm.x},
          {"stick_e0",
           {{"omega", catches.omega},
            {"vx", catches.v.x},
            {"vy", catches.v.y},
            {"impulse", json(catches.impulse)},
            {"mu_needed", std::abs(catches.impulse.x) / catches.impulse.y},
            {"energy_ratio", energy_ratio(catches)}}}};
}

}  // namespace

std::span<const Kind> truth_kinds_06_exact() {
  static constexpr std::array<Kind, 9> kinds{{
      {"bouncing_ball", bouncing_ball},
      {"stacked_drop", stacked_drop},
      {"newton_cradle", newton_cradle},
      {"simultaneous_line_impact", simultaneous_line_impact},
      {"penalty_bounce", penalty_bounce},
      {"disc_collision", disc_collision},
      {"sphere_bounce", sphere_bounce},
      {"slide_to_roll", slide_to_roll},
      {"box_edge_catch", box_edge_catch},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
