#include "common/physics/world.hpp"

#include <algorithm>
#include <cmath>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_unit(const Quat& q) {
  return std::abs(glm::dot(q, q) - 1) <= Real(1e-3);
}

bool is_positive(Real x) {
  return std::isfinite(x) && x > 0;
}

struct HasGoodSize {
  bool operator()(const Sphere& s) const { return is_positive(s.radius); }
  bool operator()(const Box& s) const { return all(s.half_extents); }
  bool operator()(const Ellipsoid& s) const { return all(s.semi_axes); }
  bool operator()(const HalfSpace& s) const {
    return is_finite(s.normal) && std::isfinite(s.offset)
           && std::abs(glm::dot(s.normal, s.normal) - 1) <= Real(1e-3);
  }
  bool operator()(const HullShape& s) const {
    return !s.vertices.empty() && std::ranges::all_of(s.vertices, is_finite);
  }
  bool operator()(const auto& s) const {
    return is_positive(s.radius) && is_positive(s.height);
  }
  static bool all(const Vec3& v) {
    return is_positive(v.x) && is_positive(v.y) && is_positive(v.z);
  }
};

struct Named {
  const char* name;
  Real value;
};

// What is wrong with a number that says how to solve; empty if nothing is
std::string settings_fault(const World& world) {
  const SolverSettings& s = world.settings;
  const PenetrationSettings& p = world.penetration;
  if (!is_finite(s.gravity)) return "gravity is not finite";
  if (s.substeps < 1) return "there are no substeps";
  for (const int count : {s.iterations, s.impact_iterations, s.impact_rounds,
                          s.contacts_at_most, p.iterations})
    if (count < 0) return "a number of iterations is negative";
  const Named numbers[] = {{"margin", world.margin},
                           {"velocity_epsilon", s.velocity_epsilon},
                           {"contact_frequency", s.contact_frequency},
                           {"damping_ratio", s.damping_ratio},
                           {"push_speed", s.push_speed},
                           {"restitution_threshold", s.restitution_threshold},
                           {"static_speed", s.static_speed},
                           {"epsilon", p.epsilon},
                           {"slop", p.slop},
                           {"beta", p.beta},
                           {"sleep.speed", world.sleep.speed},
                           {"sleep.turn", world.sleep.turn},
                           {"sleep.time", world.sleep.time}};
  for (const auto& [name, value] : numbers)
    if (!(std::isfinite(value) && value >= 0))
      return std::string(name) + " is negative or not finite";
  return "";
}

void check(const World& world, Real dt) {
  if (!is_positive(dt)) throw WorldError("dt is not positive");
  if (world.solver == nullptr) throw WorldError("no such solver");
  if (world.out_of_penetration == nullptr) throw WorldError("no such way out");
  if (world.impact_law == nullptr) throw WorldError("no such impact law");
  const std::string wrong = settings_fault(world);
  if (!wrong.empty()) throw WorldError(wrong);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const std::string fault = body_fault(world.bodies[i]);
    if (!fault.empty()) throw WorldError("body " + std::to_string(i) + ": " + fault);
  }
}

// Where the bodies are now, with the impulses that the same contacts had before
void update_contacts(World& world, Real dt) {
  std::swap(world.contacts, world.contacts_before);
  const Real falling = glm::length(world.settings.gravity);
  do {
    find_contacts(world.bodies, world.colliders, world.margin, falling, dt,
                  world.search, world.contacts);
  } while (world.sleep.is_on
           && wake_touched(world.bodies, world.contacts, world.sleep, world.sleepers));
  hold_still(world.bodies, world.settings.static_speed, world.contacts);
  carry_impulses(world.contacts_before, world.margin, world.contacts);
}

void check_handle(const World& world, BodyHandle handle) {
  const bool is_there = handle.index < world.bodies.size()
                        && world.generations[handle.index] == handle.generation
                        && world.is_there[handle.index];
  if (!is_there) throw WorldError("the body is not in the world");
}

// The first place without a body, or a new one
std::uint32_t free_place(World& world) {
  const auto found = std::ranges::find(world.is_there, false);
  const auto place = std::uint32_t(found - world.is_there.begin());
  if (found != world.is_there.end()) return place;
  world.bodies.emplace_back();
  world.generations.push_back(0);
  world.is_there.push_back(false);
  return place;
}

}  // namespace

std::string body_fault(const RigidBody& body) {
  if (!is_finite(body.position)) return "a position is not finite";
  if (!is_finite(body.velocity)) return "a velocity is not finite";
  if (!is_finite(body.angular_velocity)) return "an angular velocity is not finite";
  if (!is_unit(body.orientation)) return "an orientation is not of length one";
  if (!is_finite(body.force)) return "a force is not finite";
  if (!is_finite(body.torque)) return "a torque is not finite";
  const Vec3& k = body.inverse_inertia;
  if (!(std::isfinite(body.inverse_mass) && body.inverse_mass >= 0))
    return "a mass is not positive";
  if (!(is_finite(k) && k.x >= 0 && k.y >= 0 && k.z >= 0))
    return "a moment of inertia is not positive";
  return "";
}

std::string collider_fault(const Collider& collider) {
  if (!std::visit(HasGoodSize{}, collider.shape)) return "a size is not positive";
  if (!is_finite(collider.pose.position) || !is_unit(collider.pose.orientation))
    return "a shape's pose is not one";
  for (const Real friction :
       {collider.friction, collider.static_friction, collider.rolling_friction})
    if (!(std::isfinite(friction) && friction >= 0)) return "a friction is negative";
  if (!(collider.restitution >= 0 && collider.restitution <= 1))
    return "a restitution is not within 0 and 1";
  return "";
}

BodyHandle add_body(World& world, const RigidBody& body,
                    std::span<const Collider> colliders) {
  std::string fault = body_fault(body);
  for (const Collider& collider : colliders)
    if (fault.empty()) fault = collider_fault(collider);
  if (!fault.empty()) throw WorldError(fault);

  const std::uint32_t place = free_place(world);
  world.bodies[place] = body;
  world.is_there[place] = true;
  ++world.generations[place];
  for (const Collider& collider : colliders) {
    world.colliders.push_back(collider);
    world.colliders.back().body = place;
    world.colliders.back().id = world.next_collider++;
  }
  return {place, world.generations[place]};
}

BodyHandle add_body(World& world, const RigidBody& body, const Collider& collider) {
  return add_body(world, body, std::span(&collider, 1));
}

void remove_body(World& world, BodyHandle handle) {
  check_handle(world, handle);
  const auto is_its = [&](const Collider& c) { return c.body == handle.index; };
  std::erase_if(world.colliders, is_its);
  world.bodies[handle.index] = {};
  world.is_there[handle.index] = false;
  wake(world.sleepers);
}

RigidBody& body_of(World& world, BodyHandle handle) {
  check_handle(world, handle);
  return world.bodies[handle.index];
}

const RigidBody& body_of(const World& world, BodyHandle handle) {
  check_handle(world, handle);
  return world.bodies[handle.index];
}

void step(World& world, Real dt) {
  check(world, dt);
  if (world.sleep.is_on) hold_sleepers(world.bodies, world.sleepers);
  update_contacts(world, dt);

  // New velocities that the contacts allow, and new positions with them
  world.solver->advance({.bodies = world.bodies,
                         .contacts = world.contacts,
                         .settings = world.settings,
                         .out_of_penetration = *world.out_of_penetration,
                         .penetration = world.penetration,
                         .impact_law = *world.impact_law,
                         .dt = dt,
                         .room = world.room,
                         .penetration_room = world.penetration_room});
  if (world.sleep.is_on)
    fall_asleep(world.bodies, world.contacts, world.sleep, dt, world.sleepers);
}

RigidBody body_with_mass(Real mass, const Mat3& inertia) {
  RigidBody body;
  body.inverse_mass = 1 / mass;
  body.inverse_inertia = Vec3(1 / inertia[0][0], 1 / inertia[1][1], 1 / inertia[2][2]);
  return body;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
