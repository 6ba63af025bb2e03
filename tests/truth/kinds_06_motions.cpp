// The kinds of chapter 6 that closed forms of sliding, rolling and tipping answer,
// computed through common/physics/exact_*: in double in both precisions.
#include <array>
#include <cmath>
#include <numbers>

#include "common/graphics/input_error.hpp"
#include "common/physics/exact_rolling.hpp"
#include "common/physics/exact_sliding.hpp"
#include "common/physics/exact_tipping.hpp"
#include "tests/truth/inputs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using truth::Json;
using truth::Kind;
using truth::not_negative;
using truth::number;
using truth::positive;

constexpr double k_pi = std::numbers::pi;

// What is infinite, or has no value, is null
Json json(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json json(const glm::dvec2& v) {
  return {json(v.x), json(v.y)};
}

Json incline_block(const Json& inputs) {
  const exact::Incline incline{.angle = truth::between(inputs, "angle", 0, k_pi / 2),
                               .mu_static = not_negative(inputs, "mu_static"),
                               .mu_kinetic = not_negative(inputs, "mu_kinetic"),
                               .g = positive(inputs, "g")};
  const double v0 = number(inputs, "v0");
  const double stops = exact::stop_time(incline, v0);
  const auto end = exact::on_incline(incline, v0, not_negative(inputs, "t"));
  Json fields{{"threshold_angle", exact::threshold_angle(incline.mu_static)},
              {"slides_from_rest", exact::slides_from_rest(incline)},
              {"sliding_acceleration_down", exact::sliding_acceleration(incline)},
              {"x", end.x},
              {"v", end.v}};
  if (std::isfinite(stops)) {
    fields["stop_time"] = stops;
    fields["stop_distance"] = exact::on_incline(incline, v0, stops).x;
  }
  return fields;
}

Json incline_box_regime(const Json& inputs) {
  const exact::BoxOnIncline box{positive(inputs, "base"), positive(inputs, "height"),
                                not_negative(inputs, "mu")};
  const double slides = exact::slide_angle(box);
  const double tips = exact::tip_angle(box);
  return {{"slide_angle", slides},
          {"tip_angle", tips},
          {"tips_first", tips < slides},
          {"pressure_centre_offset_at_angle",
           json(exact::pressure_centre(box, number(inputs, "angle")))}};
}

Json rolling_incline(const Json& inputs) {
  const exact::BallOnIncline ball{.angle = truth::between(inputs, "angle", 0, k_pi / 2),
                                  .radius = positive(inputs, "radius"),
                                  .k = positive(inputs, "inertia_factor"),
                                  .mu = not_negative(inputs, "mu"),
                                  .g = not_negative(inputs, "g")};
  const double t = not_negative(inputs, "t");
  const auto [linear, angular] = exact::acceleration(ball);
  return {{"mode", exact::rolls(ball) ? "roll" : "slip"},
          {"mu_needed", exact::rolling_friction_needed(ball)},
          {"acceleration", linear},
          {"angular_acceleration", angular},
          {"x", linear * t * t / 2},
          {"v", linear * t},
          {"omega", angular * t}};
}

Json friction_cone_vs_pyramid(const Json& inputs) {
  const glm::dvec2 v{number(inputs, "vx"), number(inputs, "vy")};
  const double mu = not_negative(inputs, "mu");
  const double g = positive(inputs, "g");
  const auto cone = exact::cone_stop(v, mu, g);
  const auto pyramid = exact::pyramid_stop(v, mu, g);
  const double diagonal =
      exact::cone_stop({1, 1}, 1, 1).time / exact::pyramid_stop({1, 1}, 1, 1).time;
  return {{"cone_stop_time", json(cone.time)},
          {"cone_stop", json(cone.x)},
          {"pyramid_stop_time", json(pyramid.time)},
          {"pyramid_stop", json(pyramid.x)},
          {"pyramid_overstrength_on_diagonal", diagonal}};
}

Json book_overhang(const Json& inputs) {
  const int n = truth::count(inputs, "n");
  const double length = positive(inputs, "length");
  std::vector<double> offsets;
  for (int i = 1; i <= n; ++i) offsets.push_back(exact::overhang(length, i));
  return {{"max_overhang", exact::overhang_of_all(length, n)},
          {"offsets_from_block_below_top_first", offsets}};
}

Json sphere_leaves_sphere(const Json& inputs) {
  const exact::BallOnBall ball{.big_radius = positive(inputs, "big_radius"),
                               .radius = positive(inputs, "radius"),
                               .k = not_negative(inputs, "inertia_factor"),
                               .g = not_negative(inputs, "g")};
  const double cosine = exact::cos_leaving_angle(ball);
  return {{"cos_leave_angle", cosine},
          {"leave_angle", std::acos(cosine)},
          {"speed_at_leaving", exact::leaving_speed(ball)}};
}

Json ball_in_bowl(const Json& inputs) {
  const exact::BallInBowl ball{.bowl_radius = positive(inputs, "bowl_radius"),
                               .radius = positive(inputs, "radius"),
                               .k = not_negative(inputs, "inertia_factor"),
                               .g = positive(inputs, "g")};
  if (!(ball.bowl_radius > ball.radius))
    throw InputError("bowl_radius: must be above the ball's radius");
  const double theta0 = truth::between(inputs, "theta0", -k_pi / 2, k_pi / 2);
  const auto now = exact::ball_in_bowl(ball, theta0, number(inputs, "t"));
  return {{"theta", now.x},
          {"theta_dot", now.v},
          {"period", exact::bowl_period(ball, theta0)},
          {"small_period", 2 * k_pi / exact::bowl_frequency(ball)}};
}

Json simbenchmark_rolling(const Json& inputs) {
  const exact::BoxUnderBalls scene{.box_mass = positive(inputs, "box_mass"),
                                   .ball_mass = positive(inputs, "ball_mass"),
                                   .balls = truth::count(inputs, "balls"),
                                   .force = not_negative(inputs, "force"),
                                   .mu = not_negative(inputs, "mu_ground"),
                                   .g = positive(inputs, "g")};
  const double t = not_negative(inputs, "t");
  const auto [box, ball] = exact::accelerations(scene);
  return {{"ground_friction", exact::ground_friction(scene)},
          {"box_acceleration", box},
          {"ball_acceleration", ball},
          {"box_velocity", box * t},
          {"ball_velocity", ball * t},
          {"ball_friction_needed_mu", ball / scene.g}};
}

exact::FallingRod rod_of(const Json& inputs) {
  return {.mass = positive(inputs, "mass"),
          .length = positive(inputs, "length"),
          .g = positive(inputs, "g"),
          .theta0 = truth::between(inputs, "theta0", 0, k_pi / 2)};
}

Json falling_rod(const Json& inputs) {
  const exact::FallingRod rod = rod_of(inputs);
  const double theta = truth::between(inputs, "theta", rod.theta0, k_pi / 2);
  const auto [omega, alpha, normal, friction] = exact::rod_on_rough_floor(rod, theta);
  constexpr exact::UprightRod k_upright;
  return {{"omega", omega},
          {"alpha", alpha},
          {"friction", friction},
          {"normal_force", normal},
          {"mu_required", json(std::abs(friction) / normal)},
          {"time_from_theta0", json(exact::rod_time(rod, theta))},
          {"limit_release_vertical",
           {{"cos_theta_N_zero", k_upright.cos_normal_zero},
            {"mu_backward_slip_peak", k_upright.mu_needed},
            {"cos_theta_of_peak", k_upright.cos_most_needed},
            {"cos_theta_friction_reverses", k_upright.cos_friction_reverses}}}};
}

Json falling_rod_frictionless(const Json& inputs) {
  const exact::FallingRod rod = rod_of(inputs);
  const double theta = truth::between(inputs, "theta", rod.theta0, k_pi / 2);
  const auto now = exact::rod_on_smooth_floor(rod, theta);
  const double tip = rod.length / 2 * now.omega;
  return {{"omega", now.omega},
          {"alpha", now.alpha},
          {"normal_force", now.normal},
          {"com_speed", tip * std::sin(theta)},
          {"tip_horizontal_speed", tip * std::cos(theta)}};
}

Json painleve_rod(const Json& inputs) {
  const double theta = truth::between(inputs, "theta", 0, k_pi / 2);
  const auto [p, b, state, normal] =
      exact::painleve({.mass = positive(inputs, "mass"),
                       .half_length = positive(inputs, "half_length"),
                       .g = positive(inputs, "g"),
                       .theta = theta,
                       .omega = number(inputs, "omega"),
                       .mu = not_negative(inputs, "mu")});
  const double worst = std::atan(2.0);
  Json fields{{"p", p},
              {"b", b},
              {"mu_painleve_at_theta", json(exact::painleve_friction(theta))},
              {"mu_painleve_min", exact::painleve_friction(worst)},
              {"theta_of_min", worst}};

  // What the files call a rod that leaves the floor is not known
  using exact::Painleve;
  if (state == Painleve::parts) return fields;
  fields["normal_force"] = json(normal);
  fields["state"] = state == Painleve::slides ? "contact"
                    : state == Painleve::inconsistent
                        ? "inconsistent (impact without collision)"
                        : "indeterminate";
  return fields;
}

Json rocking_block(const Json& inputs) {
  const exact::RockingBlock block{positive(inputs, "half_width"),
                                  positive(inputs, "half_height"),
                                  positive(inputs, "g")};
  const double alpha = exact::block_angle(block);
  const double theta0 = truth::between(inputs, "theta0", 0, alpha);
  const double ratio = exact::rate_ratio(block);
  const double before = exact::impact_rate(block, theta0);
  return {{"alpha", alpha},
          {"p", exact::block_frequency(block)},
          {"omega_ratio_at_impact", ratio},
          {"energy_ratio_at_impact", ratio * ratio},
          {"quarter_time_exact", json(exact::quarter_time(block, theta0))},
          {"quarter_time_slender", json(exact::slender_quarter_time(block, theta0))},
          {"omega_before_first_impact", before},
          {"omega_after_first_impact", ratio * before},
          {"amplitude_after_first_impact", exact::next_tilt(block, theta0)}};
}

}  // namespace

std::span<const Kind> truth_kinds_06_motions() {
  static constexpr std::array<Kind, 12> kinds{{
      {"incline_block", incline_block},
      {"incline_box_regime", incline_box_regime},
      {"rolling_incline", rolling_incline},
      {"friction_cone_vs_pyramid", friction_cone_vs_pyramid},
      {"book_overhang", book_overhang},
      {"sphere_leaves_sphere", sphere_leaves_sphere},
      {"ball_in_bowl", ball_in_bowl},
      {"simbenchmark_rolling", simbenchmark_rolling},
      {"falling_rod", falling_rod},
      {"falling_rod_frictionless", falling_rod_frictionless},
      {"painleve_rod", painleve_rod},
      {"rocking_block", rocking_block},
  }};
  return kinds;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
