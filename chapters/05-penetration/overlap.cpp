#include "chapters/05-penetration/overlap.hpp"

#include <algorithm>

#include "common/physics/rotor_splitting.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

// Contacts are found across gaps as small as what the ways out leave anyway
Real margin_of(const PenetrationSettings& settings) {
  return std::max(settings.slop, settings.epsilon);
}

void fall(std::span<RigidBody> bodies, Real gravity, Real dt) {
  for (RigidBody& body : bodies)
    if (body.inverse_mass > 0) body.velocity.y -= dt * gravity;
}

// (5.4) without a share: contacts do not approach any more, and that is all
void stop_approaching(Overlap& overlap, Real dt) {
  PenetrationSettings stop = overlap.settings;
  stop.beta = 0;
  stop.slop = -margin_of(overlap.settings);
  baumgarte(overlap.bodies, overlap.contacts, stop, dt, overlap.room);
}

void take_out(Overlap& overlap, PenetrationStep way_out, Real dt) {
  // What is an iteration of worst_first is a sweep over all contacts elsewhere
  PenetrationSettings settings = overlap.settings;
  if (way_out == worst_first_projection)
    settings.iterations *= static_cast<int>(overlap.contacts.size());
  overlap.room.solved = 0;
  way_out(overlap.bodies, overlap.contacts, settings, dt, overlap.room);
}

void move(std::span<RigidBody> bodies, Real dt) {
  const auto turn = [](Rotation& r, const Vec3& I, const auto& torque, Real t, Real h) {
    rotor_splitting(r, I, torque, t, h);
  };
  for (RigidBody& body : bodies)
    if (body.inverse_mass > 0) integrate(body, turn, dt);
}

}  // namespace

void add(Overlap& overlap, const RigidBody& body, const Shape& shape) {
  const auto index = static_cast<std::uint32_t>(overlap.bodies.size());
  overlap.bodies.push_back(body);
  overlap.colliders.push_back({.body = index, .shape = shape, .id = index});
}

void add_plane(Overlap& overlap, const Vec3& normal, Real offset) {
  add(overlap, RigidBody{}, HalfSpace{normal, offset});
}

long long step(Overlap& overlap, PenetrationStep way_out, Real dt) {
  fall(overlap.bodies, overlap.gravity, dt);
  find_contacts(overlap.bodies, overlap.colliders, margin_of(overlap.settings), 0, 0,
                overlap.search, overlap.contacts);
  stop_approaching(overlap, dt);
  take_out(overlap, way_out, dt);
  move(overlap.bodies, dt);
  return overlap.room.solved;
}

Real deepest(const Overlap& overlap) {
  ContactSearch search;
  std::vector<PointContact> contacts;
  find_contacts(overlap.bodies, overlap.colliders, 0, 0, 0, search, contacts);
  Real depth = 0;
  for (const PointContact& contact : contacts) depth = std::max(depth, contact.depth);
  return depth;
}

double total_energy(const Overlap& overlap) {
  double energy = 0;
  for (const RigidBody& body : overlap.bodies)
    energy += kinetic_energy(body)
              + mass_of(body) * double(overlap.gravity) * double(body.position.y);
  return energy;
}

void equal_shares(std::span<RigidBody> bodies, std::span<PointContact> contacts,
                  const PenetrationSettings& settings, Real dt, PenetrationRoom& room) {
  std::vector<RigidBody> alike(bodies.begin(), bodies.end());
  for (RigidBody& body : alike) body.inverse_mass = body.inverse_mass > 0 ? 1 : 0;
  linear_projection(alike, contacts, settings, dt, room);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].position = alike[i].position;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
