#include "chapters/06-impulses/world_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

WorldRun::WorldRun(const Setup& setup, const View& view)
    : setup_(setup),
      view_(view),
      world_(world_of(setup)),
      origin_(setup.parameters.at("origin"), 0, 0) {}

BodyHandle WorldRun::add(const std::string& name, RigidBody body,
                         const Collider& collider, const Color& color) {
  const Bounds box = bounds(collider.shape, collider.pose);
  const Vec3 corner = glm::max(glm::abs(box.low), glm::abs(box.high));
  body.position = Vec3(glm::dvec3(body.position) + origin_);
  try {
    const BodyHandle handle = add_body(world_, body, collider);
    seen_.push_back(
        {name, handle.index, collider.shape, glm::length(glm::vec3(corner)), color});
    return handle;
  } catch (const WorldError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

// Where gravity and forces alone would take each body's velocity
void WorldRun::foresee() {
  for (Seen& seen : seen_) {
    const RigidBody& body = world_.bodies[seen.body];
    const Vec3 a = world_.settings.gravity + body.inverse_mass * body.force;
    seen.free_velocity = glm::dvec3(body.velocity) + setup_.dt * glm::dvec3(a);
  }
}

// An impact changes a velocity by more than what would carry the body's weight
void WorldRun::note_impacts() {
  constexpr double k_weights = 5;
  const double g = glm::length(glm::dvec3(world_.settings.gravity));
  for (Seen& seen : seen_) {
    const RigidBody& body = world_.bodies[seen.body];
    if (steps_ == 0 || body.inverse_mass == 0) continue;
    const glm::dvec3 change = glm::dvec3(body.velocity) - seen.free_velocity;
    if (glm::length(change) <= k_weights * g * setup_.dt) continue;
    seen.impulse = mass_of(body) * change;
    seen.hit_at = time();
  }
}

void WorldRun::step() {
  before_step();
  if (view_.impulse > 0) foresee();
  try {
    timestep::step(world_, Real(setup_.dt));
  } catch (const WorldError& error) {
    throw StepFailure(error.what());
  }
  ++steps_;
}

void WorldRun::observe() {
  // Penetration where the bodies are now, whatever the solver looked at
  find_contacts(world_.bodies, world_.colliders, 0, 0, 0, search_, touching_);
  penetration_ = 0;
  for (const PointContact& contact : touching_)
    penetration_ = std::max(penetration_, static_cast<double>(contact.depth));
  worst_penetration_ = std::max(worst_penetration_, penetration_);

  const double energy = energy_of(world_);
  if (steps_ == 0 || is_driven()) lowest_energy_ = energy;
  lowest_energy_ = std::min(lowest_energy_, energy);
  energy_gained_ = std::max(energy_gained_, energy - lowest_energy_);
  for (Seen& seen : seen_)
    if (view_.trails) seen.trail.add(picture(place(world_.bodies[seen.body])));
  if (view_.impulse > 0) note_impacts();
  after_step();
}

std::vector<BodyState> WorldRun::bodies() const {
  std::vector<BodyState> states;
  for (const Seen& seen : seen_) {
    const RigidBody& body = world_.bodies[seen.body];
    if (body.inverse_mass == 0) continue;
    states.push_back({.name = seen.name,
                      .position = glm::dvec3(body.position),
                      .velocity = glm::dvec3(body.velocity),
                      .orientation = glm::dquat(body.orientation),
                      .angular_velocity = glm::dvec3(body.angular_velocity)});
  }
  return states;
}

double WorldRun::impulse_time() const {
  return setup_.dt / (setup_.method == "substeps" ? parameter("substeps") : 1);
}

double WorldRun::fastest() const {
  double most = 0;
  for (const Seen& seen : seen_) {
    const RigidBody& body = world_.bodies[seen.body];
    const double spin = glm::length(glm::dvec3(body.angular_velocity));
    most = std::max(most, glm::length(glm::dvec3(body.velocity))
                              + (spin > 0 ? spin * double(seen.reach) : 0));
  }
  return most;
}

std::vector<Metric> WorldRun::metrics() const {
  std::vector<Metric> all = own_metrics();
  const std::vector<Metric> shared{
      {"energy", "J", energy_of(world_)},
      {"energy_gained", "J", energy_gained_},
      {"momentum", "kg m/s", glm::length(momentum_of(world_))},
      {"penetration", "m", penetration_},
      {"penetration_max", "m", worst_penetration_},
      {"fastest", "m/s", fastest()},
      {"contacts", "", static_cast<double>(touching_.size())},
  };
  all.insert(all.end(), shared.begin(), shared.end());
  return all;
}

long long WorldRun::body_count() const {
  return std::ranges::count_if(
      world_.bodies, [](const RigidBody& body) { return body.inverse_mass > 0; });
}

glm::dvec3 WorldRun::place(const RigidBody& body) const {
  return glm::dvec3(body.position) - origin_;
}

glm::vec3 WorldRun::picture(const glm::dvec3& place) const {
  const float lane = static_cast<float>(setup_.lane);
  const float middle = static_cast<float>(setup_.lanes - 1) / 2;
  return view_.scale * glm::vec3(place) + (lane - middle) * view_.lanes_apart;
}

CameraPose WorldRun::camera(const CameraPose& usual) const {
  CameraPose pose = usual;
  const float more = static_cast<float>(setup_.lanes - 1);
  pose.distance += 1.2F * more * glm::length(view_.lanes_apart);
  return pose;
}

void WorldRun::draw(DrawList& list) const {
  for (const Seen& seen : seen_) draw_body(list, seen);
  draw_contacts(list);
}

void WorldRun::draw_body(DrawList& list, const Seen& seen) const {
  const RigidBody& body = world_.bodies[seen.body];
  const bool moves = body.inverse_mass > 0;
  const Color color = moves && setup_.lanes > 1 ? setup_.style.color : seen.color;
  const glm::mat4 world_from_body =
      placed(picture(place(body)), glm::quat(body.orientation), view_.scale);
  draw_shape(list, seen.shape, world_from_body, color);
  if (!moves) return;
  const auto* ball = std::get_if<Sphere>(&seen.shape);
  if (view_.rings && ball != nullptr)
    draw_rings(list, float(ball->radius), world_from_body, k_ink);
  if (view_.trails)
    list.lines.push_back({.points = seen.trail.points(), .color = color, .fade = true});

  // An impact is over at once, too fast to be seen: its arrow stays for a while
  constexpr double k_seen_for = 0.1;  // [s]
  if (seen.hit_at >= 0 && time() - seen.hit_at < k_seen_for) {
    const glm::vec3 at = picture(place(body));
    list.arrows.push_back({.from = at,
                           .to = at + view_.impulse * glm::vec3(seen.impulse),
                           .color = k_force,
                           .width = 5});
  }
}

// Contacts of the last step: their normals, and the forces that they stand for
void WorldRun::draw_contacts(DrawList& list) const {
  for (const PointContact& contact : world_.contacts) {
    if (contact.depth < -Real(0.1) * world_.margin) continue;
    const glm::vec3 at = picture(glm::dvec3(contact.position) - origin_);
    if (view_.contacts_as_dots)
      list.markers.push_back(
          {.position = at, .style = {k_normal, MarkerShape::circle}, .size = 9});
    if (view_.normal > 0)
      list.arrows.push_back({.from = at,
                             .to = at + view_.normal * glm::vec3(contact.normal),
                             .color = k_normal,
                             .width = 3});
    const glm::vec3 force = glm::vec3(glm::dvec3(contact.impulse) / impulse_time());
    if (view_.force > 0 && force != glm::vec3(0))
      list.arrows.push_back(
          {.from = at, .to = at + view_.force * force, .color = k_force});
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
