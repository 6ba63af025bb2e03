#include "chapters/05-penetration/parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "common/graphics/palette.hpp"
#include "common/physics/exact_top.hpp"
#include "common/physics/mass_properties.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

PenetrationStep way_out_named(const std::string& name) {
  const PenetrationMethod* const method = find_penetration_method(name);
  return method == nullptr ? equal_shares : method->step;
}

glm::mat4 placed(const glm::vec3& at, const glm::dquat& q, const glm::vec3& scale) {
  glm::mat4 world_from_body = glm::mat4_cast(glm::quat(q));
  world_from_body[3] = glm::vec4(at, 1);
  return glm::scale(world_from_body, scale);
}

// The twelve edges of a box
void draw_edges(DrawList& list, const glm::mat4& world_from_box, const Color& color,
                Dash dash) {
  const auto corner = [&](int bits) {
    const glm::vec3 signs(bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1);
    return glm::vec3(world_from_box * glm::vec4(signs, 1));
  };
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if ((from & axis) != 0) continue;
      list.lines.push_back({.points = {corner(from), corner(from | axis)},
                            .color = color,
                            .width = 1.5F,
                            .dash = dash});
    }
  }
}

Place place_of(const RigidBody& body) {
  return {glm::dvec3(body.position), glm::dquat(body.orientation)};
}

}  // namespace

std::vector<Method> all_choices() {
  std::vector<Method> all;
  for (const PenetrationMethod& method : penetration_methods())
    all.push_back({std::string(method.name), std::string(method.summary),
                   method_style(static_cast<int>(all.size()))});
  return all;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const PenetrationMethod& method : penetration_methods())
    names.emplace_back(method.name);
  return names;
}

std::vector<Parameter> with_settings(std::vector<Parameter> own,
                                     const Defaults& defaults) {
  const std::vector<Parameter> settings{
      {"iterations", "", "sweeps over all contacts in a step",
       double(defaults.iterations), 1, 1000, true},
      {"beta", "", "share of a depth that is taken out", 0.2, 0, 1},
      {"slop", "m", "depth that is left, but by worst_first", defaults.slop, 0, 1e6},
      {"epsilon", "m", "depth that worst_first leaves", 1e-4, 0, 1e6},
      {"gravity", "m/s²", "downwards", defaults.gravity, 0, 1000},
      {"size", "m", "of the scene: a box's edge, a plank's length", 1, 1e-6, 1e6},
      {"origin", "m", "of the world from the scene", 0, -1e12, 1e12}};
  own.insert(own.end(), settings.begin(), settings.end());
  return own;
}

RigidBody solid(double mass, const Shape& shape, const Place& place) {
  const auto* const box = std::get_if<Box>(&shape);
  const MassProperties properties =
      box != nullptr ? solid_box(Real(mass), Real(2) * box->half_extents)
                     : solid_sphere(Real(mass), std::get<Sphere>(shape).radius);
  const Mat3& I = properties.inertia;
  RigidBody body;
  body.position = Vec3(place.position);
  body.orientation = Quat(place.orientation);
  body.inverse_mass = 1 / properties.mass;
  body.inverse_inertia = Vec3(1 / I[0][0], 1 / I[1][1], 1 / I[2][2]);
  return body;
}

OverlapRun::OverlapRun(const Setup& setup, const Lanes& lanes)
    : setup_(setup), lanes_(lanes), way_out_(way_out_named(setup.method)) {
  overlap_.settings = {.iterations = static_cast<int>(parameter("iterations")),
                       .epsilon = Real(parameter("epsilon")),
                       .slop = Real(parameter("slop")),
                       .beta = Real(parameter("beta"))};
  overlap_.gravity = Real(parameter("gravity"));
}

void OverlapRun::add_body(const char* name, RigidBody body, const Shape& shape,
                          const Place& right) {
  body.position.x += Real(origin());
  moving_.push_back({.name = name,
                     .body = overlap_.bodies.size(),
                     .start = place_of(body),
                     .right = right});
  moving_.back().right.position.x += origin();
  add(overlap_, body, shape);
}

void OverlapRun::add_wall(const Vec3& normal, double offset) {
  add_plane(overlap_, normal, Real(offset + double(normal.x) * origin()));
}

void OverlapRun::step() {
  solved_ += chapter_05::step(overlap_, way_out_, Real(setup_.dt));
}

void OverlapRun::observe() {
  penetration_ = double(deepest(overlap_));
  if (!is_observed_) {
    penetration_start_ = penetration_;
    energy_start_ = total_energy(overlap_);
    is_observed_ = true;
  }
  double kinetic = 0;
  for (const Moving& moving : moving_) {
    const RigidBody& body = overlap_.bodies[moving.body];
    kinetic += kinetic_energy(body);
    speed_max_ = std::max(speed_max_, glm::length(glm::dvec3(body.velocity)));
  }
  kinetic_max_ = std::max(kinetic_max_, kinetic);
  watch();
}

std::vector<BodyState> OverlapRun::bodies() const {
  std::vector<BodyState> states;
  for (const Moving& moving : moving_) {
    const RigidBody& body = overlap_.bodies[moving.body];
    states.push_back({.name = moving.name,
                      .position = glm::dvec3(body.position),
                      .velocity = glm::dvec3(body.velocity),
                      .orientation = glm::dquat(body.orientation),
                      .angular_velocity = glm::dvec3(body.angular_velocity)});
  }
  return states;
}

// How far the body that is farthest off is from its right place, of `across` the parts
double OverlapRun::off_place(const glm::dvec3& across) const {
  double most = 0;
  for (const Moving& moving : moving_) {
    const glm::dvec3 at(overlap_.bodies[moving.body].position);
    most = std::max(most, glm::length(across * (at - moving.right.position)));
  }
  return most;
}

double OverlapRun::off_angle() const {
  double most = 0;
  for (const Moving& moving : moving_) {
    const glm::dquat q(overlap_.bodies[moving.body].orientation);
    most = std::max(most, exact::angle_between(moving.right.orientation, q));
  }
  return most;
}

std::vector<Metric> OverlapRun::metrics() const {
  std::vector<Metric> metrics{
      {"penetration", "m", penetration_},
      {"penetration_start", "m", penetration_start_},
      {"position_error", "m", off_place({1, 1, 1})},
      {"drift", "m", off_place({1, 0, 1})},
      {"angle_error", "rad", off_angle()},
      {"speed_max", "m/s", speed_max_},
      {"kinetic_energy_max", "J", kinetic_max_},
      {"energy_put_in", "J", total_energy(overlap_) - energy_start_},
      {"contacts", "", static_cast<double>(overlap_.contacts.size())}};
  add_metrics(metrics);
  return metrics;
}

glm::vec3 OverlapRun::picture(const glm::dvec3& p) const {
  const auto column = static_cast<float>(setup_.lane % columns());
  const std::size_t row_index = setup_.lane / columns();
  const auto row = static_cast<float>(row_index);
  const glm::vec2 cell(column - static_cast<float>(columns() - 1) / 2, -row);
  const glm::vec3 here((p - glm::dvec3(origin(), 0, 0)) / size());
  return here + glm::vec3(lanes_.apart * cell, 0);
}

void OverlapRun::draw_shape(DrawList& list, const Moving& moving) const {
  const RigidBody& body = overlap_.bodies[moving.body];
  const Shape& shape = overlap_.colliders[moving.body].shape;
  const glm::vec3 at = picture(glm::dvec3(body.position));
  const float scale = static_cast<float>(1 / size());
  Color color = style().color;
  color.a = 0.75F;
  if (const auto* const box = std::get_if<Box>(&shape)) {
    const glm::vec3 half = scale * glm::vec3(box->half_extents);
    const glm::mat4 here = placed(at, body.orientation, half);
    const glm::vec3 right = picture(moving.right.position);
    list.shapes.push_back({ShapeKind::box, here, color});
    draw_edges(list, here, style().color, Dash::solid);
    draw_edges(list, placed(right, moving.right.orientation, half), k_ink,
               Dash::dotted);
  } else {
    const glm::vec3 radius(scale * static_cast<float>(std::get<Sphere>(shape).radius));
    list.shapes.push_back(
        {ShapeKind::sphere, placed(at, body.orientation, radius), color});
  }
}

void OverlapRun::draw(DrawList& list) const {
  list.markers.push_back(
      {.position = picture({origin(), 0, 0}) + lanes_.mark, .style = style()});
  for (const Moving& moving : moving_) {
    draw_shape(list, moving);
    const RigidBody& body = overlap_.bodies[moving.body];
    const glm::vec3 at = picture(glm::dvec3(body.position));
    const auto speed = glm::vec3(glm::dvec3(body.velocity) / size());
    if (glm::length(speed) > 0.05F)
      list.arrows.push_back({.from = at, .to = at + 0.3F * speed, .color = k_velocity});
  }
}

CameraPose OverlapRun::camera(const CameraPose& usual) const {
  // Wide and high enough for all lanes in a picture of 4 by 3
  const std::size_t row_count = (setup_.lanes - 1) / columns() + 1;
  const auto rows = static_cast<float>(row_count);
  const float across = lanes_.apart.x * static_cast<float>(columns()) * 3 / 4;
  const float high = 1.15F * std::max(across, lanes_.apart.y * rows);
  CameraPose pose = usual;
  pose.target.y -= lanes_.apart.y * (rows - 1) / 2;
  pose.distance =
      std::max(usual.distance, high / (2 * std::tan(usual.vertical_fov / 2)));
  return pose;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
