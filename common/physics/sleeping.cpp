#include "common/physics/sleeping.hpp"

#include <algorithm>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

bool moves(const RigidBody& body, const SleepSettings& settings) {
  return glm::dot(body.velocity, body.velocity) > settings.speed * settings.speed
         || glm::dot(body.angular_velocity, body.angular_velocity)
                > settings.turn * settings.turn;
}

bool is_disturbed(const RigidBody& body) {
  return body.force != Vec3(0) || body.torque != Vec3(0) || body.velocity != Vec3(0)
         || body.angular_velocity != Vec3(0);
}

void wake_island(std::span<RigidBody> bodies, std::uint32_t island,
                 Sleepers& sleepers) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!sleepers.asleep[i] || sleepers.island[i] != island) continue;
    bodies[i] = sleepers.held[i];
    sleepers.asleep[i] = 0;
    sleepers.rest[i] = 0;
  }
}

// The body that stands for all those united with one
std::uint32_t root_of(std::vector<std::uint32_t>& island, std::uint32_t body) {
  while (island[body] != body) body = island[body] = island[island[body]];
  return body;
}

// Bodies that are awake and touch are of one island
void unite(std::span<const RigidBody> bodies, std::span<const PointContact> contacts,
           Sleepers& sleepers) {
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (!sleepers.asleep[i]) sleepers.island[i] = i;
  for (const PointContact& c : contacts) {
    if (bodies[c.a].inverse_mass == 0 || bodies[c.b].inverse_mass == 0) continue;
    if (sleepers.asleep[c.a] || sleepers.asleep[c.b]) continue;
    const std::uint32_t a = root_of(sleepers.island, c.a);
    const std::uint32_t b = root_of(sleepers.island, c.b);
    sleepers.island[std::max(a, b)] = std::min(a, b);
  }
}

}  // namespace

void wake(Sleepers& sleepers) {
  std::ranges::fill(sleepers.asleep, std::uint8_t(0));
  std::ranges::fill(sleepers.rest, Real(0));
}

void hold_sleepers(std::span<RigidBody> bodies, Sleepers& sleepers) {
  sleepers.rest.resize(bodies.size(), 0);
  sleepers.island.resize(bodies.size(), 0);
  sleepers.asleep.resize(bodies.size(), 0);
  sleepers.held.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (sleepers.asleep[i]) sleepers.held[i] = bodies[i];
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (sleepers.asleep[i] && is_disturbed(bodies[i]))
      wake_island(bodies, sleepers.island[i], sleepers);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!sleepers.asleep[i]) continue;
    bodies[i].inverse_mass = 0;
    bodies[i].inverse_inertia = Vec3(0);
  }
}

bool wake_touched(std::span<RigidBody> bodies, std::span<const PointContact> contacts,
                  const SleepSettings& settings, Sleepers& sleepers) {
  bool woke = false;
  for (const PointContact& c : contacts) {
    for (const auto& [body, other] : {std::pair(c.a, c.b), std::pair(c.b, c.a)}) {
      if (!sleepers.asleep[body] || !moves(bodies[other], settings)) continue;
      wake_island(bodies, sleepers.island[body], sleepers);
      woke = true;
    }
  }
  return woke;
}

void fall_asleep(std::span<RigidBody> bodies, std::span<const PointContact> contacts,
                 const SleepSettings& settings, Real dt, Sleepers& sleepers) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (sleepers.asleep[i]) bodies[i] = sleepers.held[i];
    sleepers.rest[i] = moves(bodies[i], settings) ? 0 : sleepers.rest[i] + dt;
  }

  // What a moving static body touches is carried, and not at rest
  for (const PointContact& c : contacts)
    for (const auto& [body, other] : {std::pair(c.a, c.b), std::pair(c.b, c.a)})
      if (moves(bodies[other], settings)) sleepers.rest[body] = 0;

  // An island rests as long as that of its bodies that moved last
  unite(bodies, contacts, sleepers);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (sleepers.asleep[i]) continue;
    sleepers.island[i] = root_of(sleepers.island, i);
    Real& of_all = sleepers.rest[sleepers.island[i]];
    of_all = std::min(of_all, sleepers.rest[i]);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool rests = sleepers.rest[sleepers.island[i]] >= settings.time;
    if (!rests || sleepers.asleep[i] || bodies[i].inverse_mass == 0) continue;
    bodies[i].velocity = bodies[i].angular_velocity = Vec3(0);
    sleepers.asleep[i] = 1;
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
