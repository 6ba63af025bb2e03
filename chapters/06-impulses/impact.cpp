// One impact by each law: a thin rod in free flight hits the floor with its lower end.
#include <algorithm>
#include <cmath>
#include <memory>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/parts.hpp"
#include "common/chapter/trail.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

constexpr double k_approach = 0.4;    // [s] in flight before the impact
constexpr double k_thickness = 0.04;  // [m] of the rod in the picture
constexpr float k_apart = 1.5F;       // [m] from picture to picture
constexpr float k_above = 0.1F;       // [m] of the lowest floor

class OneImpact : public Simulation {
 public:
  explicit OneImpact(const Setup& setup);
  void step() override;
  void observe() override { trail_.add(picture(tip())); }
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return has_met_ ? 1 : 0; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;

 private:
  double parameter(const char* name) const { return setup_.parameters.at(name); }
  double energy() const { return kinetic_energy(rod_); }
  Vec3 tip() const;
  glm::vec3 picture(const Vec3& place) const;
  void fly(Real h);
  void meet();

  Setup setup_;
  RigidBody rod_;
  Impact impact_;
  Vec3 impulse_{0};
  double time_ = 0, energy_before_ = 0, closing_ = 0, parting_ = 0, slip_ = 0;
  bool has_met_ = false;
  Trail trail_;
};

// A rod of no thickness along its x axis, that does not turn before it hits
OneImpact::OneImpact(const Setup& setup) : setup_(setup) {
  const Real L = Real(parameter("length")), angle = Real(parameter("angle"));
  const Real I = L * L / 12;
  rod_.inverse_mass = 1;
  rod_.inverse_inertia = {1000 / I, 1 / I, 1 / I};
  rod_.orientation = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
  rod_.velocity = Vec3(Real(parameter("sideways")), -Real(parameter("down")), 0);
  rod_.position = L / 2 * Vec3(std::cos(angle), std::sin(angle), 0)
                  - Real(k_approach) * rod_.velocity;
  impact_ = {.point = Vec3(0),
             .normal = {0, 1, 0},
             .restitution = Real(parameter("restitution")),
             .friction = Real(parameter("friction"))};
  energy_before_ = energy();
}

Vec3 OneImpact::tip() const {
  return world_point(rod_, {-Real(parameter("length")) / 2, 0, 0});
}

void OneImpact::fly(Real h) {
  rod_.position += h * rod_.velocity;
  rod_.orientation =
      glm::normalize(rotation_by(h * rod_.angular_velocity) * rod_.orientation);
}

// The floor is body A
void OneImpact::meet() {
  RigidBody floor;
  closing_ = -static_cast<double>(relative_velocity(floor, rod_, impact_.point).y);
  impulse_ = find_impact_law(setup_.method)->impulse(floor, rod_, impact_);
  apply_impulse(floor, rod_, impact_.point, impulse_);
  const Vec3 v = relative_velocity(floor, rod_, impact_.point);
  parting_ = static_cast<double>(v.y);
  slip_ = static_cast<double>(std::hypot(v.x, v.z));
  has_met_ = true;
}

// The impact is where it is, not at the end of a step
void OneImpact::step() {
  const double next = time_ + setup_.dt;
  const bool meets = !has_met_ && next >= k_approach;
  if (meets) {
    fly(Real(k_approach - time_));
    meet();
  }
  fly(Real(meets ? next - k_approach : setup_.dt));
  time_ = next;
}

std::vector<BodyState> OneImpact::bodies() const {
  return {{.name = "rod",
           .position = glm::dvec3(rod_.position),
           .velocity = glm::dvec3(rod_.velocity),
           .orientation = glm::dquat(rod_.orientation),
           .angular_velocity = glm::dvec3(rod_.angular_velocity)}};
}

std::vector<Metric> OneImpact::metrics() const {
  const double normal = static_cast<double>(impulse_.y);
  const double along = static_cast<double>(std::hypot(impulse_.x, impulse_.z));
  return {{"energy_gained", "J", energy() - energy_before_},
          {"energy_before", "J", energy_before_},
          {"energy_after", "J", energy()},
          {"closing_speed", "m/s", closing_},
          {"parting_speed", "m/s", parting_},
          {"slip_after", "m/s", slip_},
          {"normal_impulse", "N s", normal},
          {"friction_used", "", normal > 0 ? along / normal : 0}};
}

// Two laws in a row, and the second row below
glm::vec3 OneImpact::picture(const Vec3& place) const {
  const std::size_t rows = (setup_.lanes - 1) / 2, row = rows - setup_.lane / 2;
  const auto column = static_cast<float>(setup_.lane % 2), up = static_cast<float>(row);
  const float left = setup_.lanes > 1 ? -k_apart / 2 : 0;
  return glm::vec3(place)
         + glm::vec3(left + k_apart * column, k_above + k_apart * up, 0);
}

void OneImpact::draw(DrawList& list) const {
  const double half = parameter("length") / 2;
  const Shape bar = Box{Vec3(Real(half), Real(k_thickness / 2), Real(k_thickness / 2))};
  const Color& color = setup_.style.color;
  const Shape floor = Box{{Real(0.6), Real(0.02), Real(0.2)}};
  draw_shape(list, floor, placed(picture({0, Real(-0.02), 0}), {1, 0, 0, 0}, 1),
             k_body);
  draw_shape(list, bar, placed(picture(rod_.position), glm::quat(rod_.orientation), 1),
             color);
  list.lines.push_back({.points = trail_.points(), .color = color, .fade = true});
  if (!has_met_) return;

  // The impulse, between the sides of Coulomb's cone
  const glm::vec3 at = picture(Vec3(0));
  const float mu = static_cast<float>(parameter("friction")), size = 0.5F;
  for (const float side : {-mu, mu})
    list.lines.push_back({.points = {at, at + size * glm::vec3(side, 1, 0)},
                          .color = k_muted,
                          .dash = Dash::dashed});
  list.arrows.push_back({.from = at,
                         .to = at + size * glm::vec3(impulse_),
                         .color = k_force,
                         .width = 5});
}

std::vector<Method> all_laws() {
  std::vector<Method> all;
  for (const ImpactLaw& law : impact_laws())
    all.push_back({std::string(law.name), std::string(law.summary),
                   method_style(static_cast<int>(all.size()))});
  return all;
}

}  // namespace

Scene impact_scene() {
  return {
      .name = "impact",
      .summary = "a thin rod of 1 kg hits the floor: one impact, by four laws",
      .methods = all_laws(),
      .default_methods = {"frictionless", "sequential_friction", "coupled_friction",
                          "poisson"},
      .parameters = {{"length", "m", "of the rod", 1, 1e-3, 1e3},
                     {"angle", "rad", "of the rod above the floor", 0.7853981633974483,
                      0, 1.5707963267948966},
                     {"sideways", "m/s", "speed along the floor", 0.6, -100, 100},
                     {"down", "m/s", "speed towards it", 1, 0, 100},
                     {"restitution", "", "of the impact", 1, 0, 1},
                     {"friction", "", "coefficient", 0.5, 0, 100}},
      .dt = 1.0 / 60,
      .duration = 0.8,
      .camera = {.target = {0, 1.25F, 0}, .distance = 4.3F, .yaw = 0, .pitch = 0.08F},
      .start = [](const Setup& setup) { return std::make_unique<OneImpact>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
