// A thin rod on one end: it falls on a rough or a smooth floor, or slides on the end
// that leads, where Painlevé found that friction leaves no force that serves.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_tipping.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

constexpr double k_mass = 1;  // [kg]

// A box so thin, over its length: what is exact for a rod without thickness is out by
// some of its squares, if angles are those of the line from the edge that it stands on
constexpr double k_thin = 1e-3, k_edge = k_thin;

class Rod : public WorldRun {
 public:
  explicit Rod(const Setup& setup);
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  double length() const { return parameter("length"); }
  double weight() const { return k_mass * parameter("gravity"); }
  bool is_falling() const { return parameter("speed") == 0; }
  double lean() const;
  double pressure() const;
  exact::RodMotion exact_now() const;
  exact::PainleveForces painleve() const;
  void compare();

  BodyHandle rod_{};
  bool compares_ = true;
  double rate_error_ = 0, pressure_error_ = 0, time_error_ = 0, until_ = 0;
  double first_pressure_ = 0;
};

// The rod is 1 m long in the picture
Rod::Rod(const Setup& setup)
    : WorldRun(setup, {.scale = 1 / float(setup.parameters.at("length")),
                       .force = 0.5F / float(setup.parameters.at("gravity")),
                       .contacts_as_dots = true}) {
  const double mu = parameter("friction"), half = length() / 2;
  const double tilt = parameter("tilt");
  add("floor", RigidBody{}, floor_collider(mu, 0), k_body);

  // From the edge that it stands on, the centre is in the direction of the lean,
  const glm::dvec3 size(k_thin * length(), length(), k_thin * length());
  const glm::dvec3 middle =
      half * std::hypot(1, k_thin) * glm::dvec3(std::sin(tilt), std::cos(tilt), 0);
  // and nothing turns it about its own axis
  RigidBody rod = box_body(k_mass, size, middle);
  rod.inverse_inertia.y = 0;
  rod.orientation = Quat(glm::angleAxis(-tilt - k_edge, glm::dvec3(0, 0, 1)));
  rod.velocity = {-Real(parameter("speed")), 0, 0};
  rod_ = add("rod", rod, box_collider(size, mu, 0), body_color(0));
}

// From upright [rad]: of that line
double Rod::lean() const {
  const glm::dvec3 along =
      glm::dquat(body_of(world(), rod_).orientation) * glm::dvec3(0, 1, 0);
  return std::atan2(along.x, along.y) - k_edge;
}

// The floor's force upwards, over the weight
double Rod::pressure() const {
  double sum = 0;
  for (const PointContact& contact : world().contacts)
    sum += std::abs(double(contact.impulse.y));
  return sum / (impulse_time() * weight());
}

// Where the rod now is, on its way from rest
exact::RodMotion Rod::exact_now() const {
  const exact::FallingRod rod{k_mass, length(), parameter("gravity"),
                              parameter("tilt")};
  return parameter("friction") == 0 ? rod_on_smooth_floor(rod, lean())
                                    : rod_on_rough_floor(rod, lean());
}

// At the start. Its angle is that to the floor
exact::PainleveForces Rod::painleve() const {
  return exact::painleve({.mass = k_mass,
                          .half_length = length() / 2,
                          .g = parameter("gravity"),
                          .theta = std::numbers::pi / 2 - parameter("tilt"),
                          .omega = 0,
                          .mu = parameter("friction")});
}

// With what is exact for the lean that the rod has, as long as friction can hold its
// end easily and until it lies
void Rod::compare() {
  const exact::RodMotion exact = exact_now();
  const double tilt = parameter("tilt");
  const bool holds =
      std::abs(exact.friction) <= 0.8 * parameter("friction") * exact.normal;
  compares_ = compares_ && holds && lean() < 1.5 && lean() >= tilt;
  if (!compares_) return;
  until_ = lean();
  const double unit = std::sqrt(parameter("gravity") / length());
  const double rate = -double(body_of(world(), rod_).angular_velocity.z);
  rate_error_ = std::max(rate_error_, std::abs(rate - exact.omega) / unit);
  pressure_error_ =
      std::max(pressure_error_, std::abs(pressure() - exact.normal / weight()));
  if (parameter("friction") == 0 || lean() == tilt) return;
  const exact::FallingRod rod{k_mass, length(), parameter("gravity"), tilt};
  time_error_ = time() - exact::rod_time(rod, lean());
}

void Rod::after_step() {
  if (steps() == 1) first_pressure_ = pressure();
  if (is_falling() && steps() > 0) compare();
}

std::vector<Metric> Rod::own_metrics() const {
  const exact::PainleveForces forces = painleve();
  const double start_exact = is_falling()                   ? 0
                             : std::isfinite(forces.normal) ? forces.normal / weight()
                                                            : 0;
  return {
      {"rate_error_max", "", rate_error_},
      {"pressure_error_max", "", pressure_error_},
      {"time_error", "s", time_error_},
      {"compared_until", "rad", until_},
      {"lean", "rad", lean()},
      {"pressure", "", pressure()},
      {"painleve_p", "1/kg", forces.p},
      {"painleve_b", "m/s²", forces.b},
      {"first_pressure", "", first_pressure_},
      {"first_pressure_exact", "", start_exact},
  };
}

// Thicker than it is
void Rod::draw(DrawList& list) const {
  WorldRun::draw(list);
  const RigidBody& rod = body_of(world(), rod_);
  const Color color = setup().lanes > 1 ? setup().style.color : body_color(0);
  draw_shape(list, Box{Vec3(Real(0.02), Real(0.5), Real(0.02))},
             placed(picture(place(rod)), glm::quat(rod.orientation), 1), color);
}

void Rod::draw_reference(DrawList& list) const {
  if (!is_falling() || parameter("friction") == 0) return;

  // The arc of the upper end, while the lower one does not slip
  std::vector<glm::vec3> arc;
  constexpr int k_pieces = 48;
  const double tilt = parameter("tilt");
  for (int i = 0; i <= k_pieces; ++i) {
    const double angle = tilt + (std::numbers::pi / 2 - tilt) * i / k_pieces;
    arc.push_back(picture(length() * glm::dvec3(std::sin(angle), std::cos(angle), 0)));
  }
  list.lines.push_back(
      {.points = arc, .color = k_ink, .width = 2, .dash = Dash::dashed});
  list.legend.push_back({reference_style(), "exact, if the end stays"});
}

}  // namespace

Scene rod_scene() {
  return {
      .name = "rod",
      .summary = "a rod falls over, on a rough floor or a smooth one, or jams",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"length", "m", "of the rod", 1, 1e-6, 1e6},
           {"tilt", "rad", "from upright at the start", 0.2, 0, 1.5},
           {"friction", "", "of rod and floor", 0.6, 0, 100},
           {"speed", "m/s", "of the rod, its end ahead; 0: it falls", 0, 0, 1000}}),
      .presets = {{"smooth", "made for this chapter", {{"friction", 0}}},
                  {"slides",
                   "made for this chapter",
                   {{"tilt", 0.4636476090008061}, {"friction", 1}, {"speed", 3}}},
                  {"painleve",
                   "Painlevé (1895): friction above 4/3 leaves no force that serves",
                   {{"tilt", 0.4636476090008061}, {"friction", 2}, {"speed", 3}}}},
      .dt = 1.0 / 240,
      .duration = 1,
      .camera = {.target = {0.45F, 0.48F, 0},
                 .distance = 2.0F,
                 .yaw = 0.1F,
                 .pitch = 0.12F},
      .chart_metric = "pressure",
      .start = [](const Setup& setup) { return std::make_unique<Rod>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
