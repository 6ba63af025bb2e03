#include "common/physics/penetration.hpp"

#include <algorithm>
#include <array>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Bodies = std::span<RigidBody>;
using Contacts = std::span<PointContact>;

void anchor_all(Bodies bodies, Contacts contacts, PenetrationRoom& room) {
  room.anchors.clear();
  for (const PointContact& c : contacts)
    room.anchors.push_back(anchors_of(c, bodies[c.a], bodies[c.b]));
}

void measure_all(Bodies bodies, Contacts contacts, const PenetrationRoom& room) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    PointContact& c = contacts[i];
    c.depth = depth_now(c, room.anchors[i], bodies[c.a], bodies[c.b]);
  }
}

// The arms of a contact's middle, and the inverse of its effective mass
struct Lever {
  Vec3 a, b;
  Real k;
};

Lever lever(const PointContact& c, const RigidBody& a, const RigidBody& b,
            const Vec3& point) {
  const Vec3 arm_a = point - a.position, arm_b = point - b.position;
  return {arm_a, arm_b,
          inverse_effective_mass(a, arm_a, c.normal)
              + inverse_effective_mass(b, arm_b, c.normal)};
}

// (5.3) Takes a length out of a contact: the impulse that moves its points apart by it
void push_apart(Bodies bodies, const PointContact& c, const ContactAnchors& anchors,
                Real length) {
  RigidBody &a = bodies[c.a], &b = bodies[c.b];
  const Vec3 middle =
      (world_point(a, anchors.on_a) + world_point(b, anchors.on_b)) / Real(2);
  const Lever arms = lever(c, a, b, middle);
  const Vec3 impulse = length / arms.k * c.normal;
  push(a, arms.a, -impulse);
  push(b, arms.b, impulse);
}

// (5.4) Gauss-Seidel on the velocities of `bodies`: each contact parts at its bias,
// with impulses that never pull
void part_at_bias(Bodies bodies, Contacts contacts, const PenetrationSettings& settings,
                  Real dt, PenetrationRoom& room) {
  std::vector<Real>& impulses = room.impulses;
  impulses.assign(contacts.size(), 0);
  for (int k = 0; k < settings.iterations; ++k) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const PointContact& c = contacts[i];
      const Real beyond = c.depth - settings.slop;
      if (beyond <= 0) continue;
      ++room.solved;
      RigidBody &a = bodies[c.a], &b = bodies[c.b];
      const Lever arms = lever(c, a, b, c.position);
      const Real speed =
          glm::dot(velocity_at(b, c.position) - velocity_at(a, c.position), c.normal);
      const Real before = impulses[i];
      const Real wanted = before + (settings.beta / dt * beyond - speed) / arms.k;
      impulses[i] = std::max(wanted, Real(0));

      const Vec3 impulse = (impulses[i] - before) * c.normal;
      a.velocity -= a.inverse_mass * impulse;
      b.velocity += b.inverse_mass * impulse;
      a.angular_velocity -= world_inverse_inertia(a) * glm::cross(arms.a, impulse);
      b.angular_velocity += world_inverse_inertia(b) * glm::cross(arms.b, impulse);
    }
  }
}

}  // namespace

ContactAnchors anchors_of(const PointContact& contact, const RigidBody& a,
                          const RigidBody& b) {
  const Vec3 half = contact.depth / 2 * contact.normal;
  return {point_in_body(pose_of(a), contact.position + half),
          point_in_body(pose_of(b), contact.position - half)};
}

Real depth_now(const PointContact& contact, const ContactAnchors& anchors,
               const RigidBody& a, const RigidBody& b) {
  // Positions first, so that places far away cost no digits
  const Vec3 overlap = (a.position - b.position)
                       + (a.orientation * anchors.on_a - b.orientation * anchors.on_b);
  return glm::dot(contact.normal, overlap);
}

Real inverse_effective_mass(const RigidBody& body, const Vec3& arm,
                            const Vec3& normal) {
  const Vec3 across = glm::cross(arm, normal);
  return body.inverse_mass + glm::dot(across, world_inverse_inertia(body) * across);
}

void push(RigidBody& body, const Vec3& arm, const Vec3& impulse) {
  body.position += body.inverse_mass * impulse;
  const Vec3 turn = world_inverse_inertia(body) * glm::cross(arm, impulse);
  if (turn == Vec3(0)) return;
  body.orientation = glm::normalize(rotation_by(turn) * body.orientation);
}

void linear_projection(Bodies bodies, Contacts contacts,
                       const PenetrationSettings& settings, Real /*dt*/,
                       PenetrationRoom& room) {
  anchor_all(bodies, contacts, room);
  for (int k = 0; k < settings.iterations; ++k) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const PointContact& c = contacts[i];
      RigidBody &a = bodies[c.a], &b = bodies[c.b];
      const Real beyond = depth_now(c, room.anchors[i], a, b) - settings.slop;
      if (beyond <= 0) continue;
      ++room.solved;

      // (5.2) Formula 4
      const Real masses = a.inverse_mass + b.inverse_mass;
      const Vec3 apart = settings.beta * beyond / masses * c.normal;
      a.position -= a.inverse_mass * apart;
      b.position += b.inverse_mass * apart;
    }
  }
  measure_all(bodies, contacts, room);
}

void worst_first_projection(Bodies bodies, Contacts contacts,
                            const PenetrationSettings& settings, Real /*dt*/,
                            PenetrationRoom& room) {
  anchor_all(bodies, contacts, room);
  for (int k = 0; k < settings.iterations && !contacts.empty(); ++k) {
    const auto worst = std::ranges::max_element(contacts, {}, &PointContact::depth);
    if (worst->depth <= settings.epsilon) break;
    push_apart(bodies, *worst, room.anchors[std::size_t(worst - contacts.begin())],
               worst->depth);
    ++room.solved;

    // What moved with it is deeper now, or less deep
    const auto [a, b] = std::pair(worst->a, worst->b);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      PointContact& c = contacts[i];
      if (c.a == a || c.a == b || c.b == a || c.b == b)
        c.depth = depth_now(c, room.anchors[i], bodies[c.a], bodies[c.b]);
    }
  }
}

void baumgarte(Bodies bodies, Contacts contacts, const PenetrationSettings& settings,
               Real dt, PenetrationRoom& room) {
  part_at_bias(bodies, contacts, settings, dt, room);
}

void split_impulse(Bodies bodies, Contacts contacts,
                   const PenetrationSettings& settings, Real dt,
                   PenetrationRoom& room) {
  anchor_all(bodies, contacts, room);
  room.pseudo.assign(bodies.begin(), bodies.end());
  for (RigidBody& body : room.pseudo) body.velocity = body.angular_velocity = Vec3(0);
  part_at_bias(room.pseudo, contacts, settings, dt, room);

  // (5.5) They act once, and are gone
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const RigidBody& pseudo = room.pseudo[i];
    if (pseudo.velocity == Vec3(0) && pseudo.angular_velocity == Vec3(0)) continue;
    bodies[i].position += dt * pseudo.velocity;
    bodies[i].orientation = glm::normalize(rotation_by(dt * pseudo.angular_velocity)
                                           * bodies[i].orientation);
  }
  measure_all(bodies, contacts, room);
}

void ngs(Bodies bodies, Contacts contacts, const PenetrationSettings& settings,
         Real /*dt*/, PenetrationRoom& room) {
  anchor_all(bodies, contacts, room);
  for (int k = 0; k < settings.iterations; ++k) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const PointContact& c = contacts[i];
      const Real depth = depth_now(c, room.anchors[i], bodies[c.a], bodies[c.b]);
      const Real beyond = depth - settings.slop;
      if (beyond <= 0) continue;
      push_apart(bodies, c, room.anchors[i], settings.beta * beyond);
      ++room.solved;
    }
  }
  measure_all(bodies, contacts, room);
}

std::span<const PenetrationMethod> penetration_methods() {
  static constexpr std::array<PenetrationMethod, 5> k_methods{{
      {"linear_projection", "apart along the normal, by inverse mass: Formula 4",
       linear_projection},
      {"worst_first", "the deepest first, moved and turned: the thesis's",
       worst_first_projection},
      {"baumgarte", "a velocity that takes a share out in each step", baumgarte},
      {"split_impulse", "the same velocity, forgotten after the step", split_impulse},
      {"ngs", "shares of the depths as they are now, contact by contact", ngs},
  }};
  return k_methods;
}

const PenetrationMethod* find_penetration_method(std::string_view name) {
  for (const PenetrationMethod& method : penetration_methods())
    if (method.name == name) return &method;
  return nullptr;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
