#include <algorithm>

#include "common/physics/solvers.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

Real closing_speed(const SolverStep& step, const PointContact& c) {
  const Vec3 v = relative_velocity(step.bodies[c.a], step.bodies[c.b], c.position);
  return -glm::dot(v, c.normal);
}

// Velocity [m/s] that forces give a body in the step
Vec3 gained(const SolverStep& step, const RigidBody& body) {
  if (body.inverse_mass == 0) return Vec3(0);
  return step.dt * (step.settings.gravity + newton(body.force, body.inverse_mass));
}

// (6.4) What forces alone added to the closing speed in this step is no impact, nor is
// what they add in one step of flight: without it resting bodies do not bounce
Impact impact_at(const SolverStep& step, const PointContact& c, Real closing) {
  const Vec3 gain = gained(step, step.bodies[c.b]) - gained(step, step.bodies[c.a]);
  const Real fall = std::max(-glm::dot(gain, c.normal), Real(0));
  const Real before = closing - fall;
  const bool bounces = before > std::max(step.settings.restitution_threshold, fall);
  return {.point = c.position,
          .normal = c.normal,
          .restitution = bounces ? c.restitution * before / closing : 0,
          .friction = c.friction};
}

// No further apart than what ways out of a penetration leave
bool touches(const SolverStep& step, const PointContact& c) {
  return c.depth >= -std::max(step.penetration.epsilon, step.penetration.slop);
}

// (6.9), (6.10) Listings 8 and 9: the fastest contact, again and again, until that one
// is slow enough; then Listing 7 for those that share a body with it
void resolve_velocities(const SolverStep& step, std::vector<Real>& closing) {
  const auto contacts = step.contacts;
  closing.clear();
  for (const PointContact& c : contacts)
    closing.push_back(touches(step, c) ? closing_speed(step, c) : 0);
  for (int k = 0; k < step.settings.contacts_at_most && !closing.empty(); ++k) {
    const auto fastest = std::ranges::max_element(closing);
    if (*fastest <= step.settings.velocity_epsilon) return;
    PointContact& primary = contacts[std::size_t(fastest - closing.begin())];
    RigidBody &a = step.bodies[primary.a], &b = step.bodies[primary.b];
    const Vec3 impulse =
        step.impact_law.impulse(a, b, impact_at(step, primary, *fastest));
    apply_impulse(a, b, primary.position, impulse);
    primary.impulse += impulse;
    ++step.room.solved;

    // (6.8)
    const auto is_moved = [&](std::uint32_t body) {
      return (body == primary.a || body == primary.b)
             && step.bodies[body].inverse_mass > 0;
    };
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (touches(step, contacts[i])
          && (is_moved(contacts[i].a) || is_moved(contacts[i].b)))
        closing[i] = closing_speed(step, contacts[i]);
  }
}

}  // namespace

void worst_first(const SolverStep& step) {
  step.out_of_penetration.step(step.bodies, step.contacts, step.penetration, step.dt,
                               step.penetration_room);
  for (RigidBody& body : step.bodies) {
    body.velocity += gained(step, body);
    body.angular_velocity += step.dt * (world_inverse_inertia(body) * body.torque);
  }
  for (PointContact& c : step.contacts) c.impulse = Vec3(0);
  resolve_velocities(step, step.room.closing);
  move_bodies(step.bodies, step.dt);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
