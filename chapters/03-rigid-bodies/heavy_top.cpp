// A spinning top on its tip: gravity pulls it over, and it goes round instead.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "chapters/03-rigid-bodies/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_heavy_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

// The closed forms have z upwards, the scene has y: z to y, y to -z
glm::dquat world_from_upright() {
  return glm::angleAxis(-std::numbers::pi / 2, glm::dvec3(1, 0, 0));
}

exact::HeavyTop top_of(const Setup& setup) {
  const auto& p = setup.parameters;
  return {.I1 = p.at("i1"),
          .I3 = p.at("i3"),
          .mass = p.at("mass"),
          .g = p.at("gravity"),
          .l = p.at("length")};
}

exact::HeavyTopStart start_of(const Setup& setup) {
  const auto& p = setup.parameters;
  return {
      .theta = p.at("theta"), .phi_rate = p.at("precession"), .omega3 = p.at("spin")};
}

exact::Turning exact_at(const Setup& setup, double t) {
  const exact::HeavyTopStart start = start_of(setup);
  exact::Turning top =
      exact::turning(exact::heavy_top(top_of(setup), start, t), start.omega3);
  top.q = world_from_upright() * top.q;
  return top;
}

glm::dvec3 moments_about_pivot(const Setup& setup) {
  const exact::HeavyTop top = top_of(setup);

  // (3.9) Steiner's part, and what a disc as flat as can be has across its axis
  const double least = top.mass * top.l * top.l + top.I3 / 2;
  if (top.I1 < least * (1 - 1e-12))
    throw InputError(
        fmt::format("--set i1={:g}: no top of this mass, length and i3 has less than "
                    "{:g} kg m² across its axis",
                    top.I1, least));
  return {top.I1, top.I1, top.I3};
}

// (3.5) The weight at the centre of mass, about the pivot
Torque weight_of(const Setup& setup) {
  const exact::HeavyTop top = top_of(setup);
  return [l = Real(top.l), mg = Real(top.mass * top.g)](const Quat& q, Real) {
    return glm::cross(q * Vec3(0, 0, l), Vec3(0, -mg, 0));
  };
}

class HeavyTop : public TopRun {
 public:
  explicit HeavyTop(const Setup& setup);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  double energy(const exact::Turning& top) const;
  // Angular momentum about the vertical, which the weight does not change
  double upright_momentum(const exact::Turning& top) const {
    return exact::angular_momentum(top, moments()).y;
  }
  // Of the axis from upright [rad]
  static double tilt(const exact::Turning& top) {
    return exact::angle_between(top.q * glm::dvec3(0, 0, 1), {0, 1, 0});
  }

  exact::HeavyTop top_;
  exact::Turning start_, exact_;
  double worst_attitude_ = 0, worst_energy_ = 0, worst_momentum_ = 0;
  double least_tilt_, most_tilt_;
  Trail path_, exact_path_;
};

HeavyTop::HeavyTop(const Setup& setup)
    : TopRun(setup, moments_about_pivot(setup), exact_at(setup, 0), weight_of(setup)),
      top_(top_of(setup)),
      start_(exact_at(setup, 0)),
      exact_(start_),
      least_tilt_(tilt(start_)),
      most_tilt_(least_tilt_) {}

double HeavyTop::energy(const exact::Turning& top) const {
  const double height = top_.l * (top.q * glm::dvec3(0, 0, 1)).y;
  return exact::rotational_energy(top, moments()) + top_.mass * top_.g * height;
}

void HeavyTop::observe() {
  exact_ = exact_at(setup(), time());
  const exact::Turning top = now();
  worst_attitude_ = std::max(worst_attitude_, exact::angle_between(exact_.q, top.q));
  worst_energy_ = std::max(worst_energy_, std::abs(energy(top) - energy(start_)));
  worst_momentum_ = std::max(
      worst_momentum_, std::abs(upright_momentum(top) - upright_momentum(start_)));
  least_tilt_ = std::min(least_tilt_, tilt(top));
  most_tilt_ = std::max(most_tilt_, tilt(top));
  path_.add(picture(top.q * glm::dvec3(0, 0, 2.2)));
  exact_path_.add(picture(exact_.q * glm::dvec3(0, 0, 2.2)));
}

std::vector<BodyState> HeavyTop::bodies() const {
  const exact::Turning top = now();
  const glm::dvec3 omega = top.q * top.omega;
  const glm::dvec3 centre = top.q * glm::dvec3(0, 0, top_.l);
  return {{.name = "top",
           .position = centre,
           .velocity = glm::cross(omega, centre),
           .orientation = top.q,
           .angular_velocity = omega}};
}

// Energies in units of the kinetic energy at the start and the weight's range together
std::vector<Metric> HeavyTop::metrics() const {
  const double scale =
      exact::rotational_energy(start_, moments()) + 2 * top_.mass * top_.g * top_.l;
  const exact::HeavyTopStart start = start_of(setup());
  const exact::Nutation exact = exact::nutation(top_, start);
  const auto steady = exact::steady_precession(top_, start.theta, start.omega3);
  return {
      {"attitude_error", "rad", exact::angle_between(exact_.q, now().q)},
      {"attitude_error_max", "rad", worst_attitude_},
      {"energy_error", "", scale > 0 ? (energy(now()) - energy(start_)) / scale : 0},
      {"energy_error_max", "", scale > 0 ? worst_energy_ / scale : 0},
      {"vertical_momentum_error_max", "kg m²/s", worst_momentum_},
      {"spin", "rad/s", now().omega.z},
      {"tilt", "rad", tilt(now())},
      {"tilt_exact", "rad", tilt(exact_)},
      {"tilt_min", "rad", least_tilt_},
      {"tilt_max", "rad", most_tilt_},
      {"tilt_min_exact", "rad", exact.theta_min},
      {"tilt_max_exact", "rad", exact.theta_max},
      {"nutation_period_exact", "s", std::isfinite(exact.period) ? exact.period : 0},
      {"steady_precession_exact", "rad/s", steady ? steady->slow : 0},
  };
}

// A disc on an axle; the axle's length in the picture is 2, whatever the top's
void draw_top(DrawList& list, const glm::dquat& q, const Style& style, bool with_disc) {
  const glm::mat4 upright = placed({0, 0, 0}, q);
  const auto at = [&](float z) { return glm::vec3(upright * glm::vec4(0, 0, z, 1)); };
  list.lines.push_back({.points = {at(0), at(2.2F)},
                        .color = style.color,
                        .width = 3,
                        .dash = style.dash});
  list.markers.push_back({.position = at(2.2F), .style = style, .size = 12});
  if (!with_disc) return;

  const glm::mat4 along_y =
      glm::rotate(upright, glm::half_pi<float>(), glm::vec3(1, 0, 0));
  const auto slab = [&](float z, float radius, float half, const Color& color) {
    const glm::mat4 there = glm::translate(along_y, glm::vec3(0, z, 0));
    list.shapes.push_back({ShapeKind::cylinder,
                           glm::scale(there, glm::vec3(radius, half, radius)), color});
  };
  slab(1.3F, 0.85F, 0.1F, k_body);
  slab(1.42F, 0.3F, 0.06F, style.color);
  const glm::vec3 spot(upright * glm::vec4(0.65F, 0, 1.41F, 1));
  list.balls.push_back({spot, 0.09F, style.color});
}

void HeavyTop::draw(DrawList& list) const {
  draw_top(list, now().q, setup().style, setup().lane == 0);
  list.lines.push_back({.points = path_.points(),
                        .color = setup().style.color,
                        .dash = setup().style.dash,
                        .fade = true});
}

void HeavyTop::draw_reference(DrawList& list) const {
  draw_top(list, exact_.q, reference_style(), false);
  list.lines.push_back({.points = exact_path_.points(),
                        .color = k_ink,
                        .width = 1.5F,
                        .dash = Dash::dashed});
  list.legend.push_back({reference_style(), "exact"});
}

}  // namespace

Scene heavy_top_scene() {
  return {
      .name = "heavy-top",
      .summary = "a top on its tip: precession and nutation, beside their closed form",
      .methods = all_choices(),
      .default_methods = {"splitting", "implicit_gyroscopic", "rk4"},
      .parameters = {{"i1", "kg m²", "about the tip, across the axis", 0.05, 1e-9, 1e9},
                     {"i3", "kg m²", "about the axis", 0.01, 1e-9, 1e9},
                     {"mass", "kg", "of the top", 1, 0, 1e9},
                     {"length", "m", "from the tip to the centre of mass", 0.2, 0, 1e6},
                     {"gravity", "m/s²", "downwards", 9.81, 0, 1e3},
                     {"theta", "rad", "tilt at the start, from upright", 0.5, 0,
                      std::numbers::pi},
                     {"precession", "rad/s", "at the start, about the vertical", 0,
                      -1e4, 1e4},
                     {"spin", "rad/s", "about the axis", 60, -1e4, 1e4}},
      .dt = 1.0 / 240,
      .duration = 5,
      .camera = {.target = {0, 1.1F, 0}, .distance = 7, .yaw = 0.4F, .pitch = 0.35F},
      .chart_metric = "attitude_error",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<HeavyTop>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
