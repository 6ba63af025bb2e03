#include "common/physics/contact_rows.hpp"

#include <algorithm>
#include <cmath>

#include "common/physics/impulse.hpp"
#include "common/physics/shapes.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

SolverBody solver_body(const RigidBody& body, const Vec3& gravity) {
  SolverBody s{.velocity = body.velocity,
               .angular_velocity = body.angular_velocity,
               .inverse_mass = body.inverse_mass,
               .inverse_inertia = world_inverse_inertia(body)};
  if (body.inverse_mass > 0)
    s.acceleration = gravity + newton(body.force, body.inverse_mass);
  s.angular_acceleration = s.inverse_inertia * body.torque;
  return s;
}

// (6.2) Inverse effective masses [1/kg] along the normal, and the largest along the
// surface: an eigenvalue of the part of K there
struct InverseMasses {
  Real normal, tangent;
};

InverseMasses inverse_masses(const ContactRow& row, const Mat3& basis,
                             const SolverBody& a, const SolverBody& b) {
  Mat3 k(0);
  for (const auto& [body, arm] :
       {std::pair(&a, &row.arm_a), std::pair(&b, &row.arm_b)}) {
    Mat3 across, turned;
    for (glm::length_t i = 0; i < 3; ++i) {
      across[i] = glm::cross(*arm, basis[i]);
      turned[i] = body->inverse_inertia * across[i];
    }
    k[0][0] += body->inverse_mass + glm::dot(across[0], turned[0]);
    k[1][1] += body->inverse_mass + glm::dot(across[1], turned[1]);
    k[2][2] += body->inverse_mass + glm::dot(across[2], turned[2]);
    k[1][2] += glm::dot(across[1], turned[2]);
  }
  const Real middle = (k[1][1] + k[2][2]) / 2, half = (k[1][1] - k[2][2]) / 2;
  return {k[0][0], middle + std::sqrt(half * half + k[1][2] * k[1][2])};
}

// A body's velocities, and what they answer to impulses
struct Motion {
  Vec3 velocity, angular_velocity;
};

Motion motion_of(const SolverBody& body) {
  return {body.velocity, body.angular_velocity};
}

void set_motion(SolverBody& body, const Motion& motion) {
  body.velocity = motion.velocity;
  body.angular_velocity = motion.angular_velocity;
}

// (6.8)
inline void apply(const SolverBody& body, const Vec3& arm, const Vec3& impulse,
                  Motion& motion) {
  motion.velocity += body.inverse_mass * impulse;
  motion.angular_velocity += body.inverse_inertia * glm::cross(arm, impulse);
}

// (6.5)
Vec3 limited_friction(const ContactRow& row, const Vec3& wanted, bool use_pyramid) {
  if (use_pyramid)
    return in_pyramid(wanted, row.friction, row.normal_impulse,
                      contact_basis(row.normal));
  const Real most = row.friction * row.normal_impulse;
  const Real squared = glm::dot(wanted, wanted);
  return squared > most * most ? most / std::sqrt(squared) * wanted : wanted;
}

// (6.11) What the row asks for now, and what it has been given so far
void resolve(ContactRow& row, const SolverBody& a, const SolverBody& b, Motion& of_a,
             Motion& of_b, bool use_pyramid) {
  // (6.1)
  const Vec3 v = of_b.velocity + glm::cross(of_b.angular_velocity, row.arm_b)
                 - of_a.velocity - glm::cross(of_a.angular_velocity, row.arm_a);
  const Real v_n = glm::dot(v, row.normal);

  // (6.12) Along the normal
  const Real before = row.normal_impulse;
  const Real wanted = before
                      - row.soft.mass_scale * row.normal_mass * (v_n - row.target)
                      - row.soft.impulse_scale * before;
  row.normal_impulse = std::max(wanted, Real(0));

  // (6.5) Along the surface
  const Vec3 friction_before = row.tangent_impulse;
  const Vec3 slip = v - v_n * row.normal;
  row.tangent_impulse =
      limited_friction(row, friction_before - row.tangent_mass * slip, use_pyramid);

  const Vec3 impulse = (row.normal_impulse - before) * row.normal
                       + (row.tangent_impulse - friction_before);
  apply(a, row.arm_a, -impulse, of_a);
  apply(b, row.arm_b, impulse, of_b);
}

// (6.5) The torque of rolling friction, against the turn about axes along the surface
void resist_rolling(RollingRow& rolling, SolverRoom& room) {
  const ContactRow& row = room.rows[rolling.row];
  SolverBody &a = room.bodies[row.a], &b = room.bodies[row.b];
  const Vec3 turn = b.angular_velocity - a.angular_velocity;
  const Vec3 roll = turn - glm::dot(turn, row.normal) * row.normal;
  const Vec3 axis = unit_or_zero(roll);
  const Real inverse = glm::dot(axis, (a.inverse_inertia + b.inverse_inertia) * axis);
  if (inverse <= 0) return;

  const Vec3 before = rolling.impulse;
  rolling.impulse = in_cone(before - roll / inverse, rolling.arm, row.normal_impulse);
  a.angular_velocity -= a.inverse_inertia * (rolling.impulse - before);
  b.angular_velocity += b.inverse_inertia * (rolling.impulse - before);
}

// Calls `change` for each row with its bodies and their motions, which stay at hand
// while rows are about the same pair
void for_each_row(SolverRoom& room, const auto& change) {
  std::vector<ContactRow>& rows = room.rows;
  for (std::size_t i = 0; i < rows.size();) {
    const std::uint32_t first = rows[i].a, second = rows[i].b;
    SolverBody &a = room.bodies[first], &b = room.bodies[second];
    Motion of_a = motion_of(a), of_b = motion_of(b);
    for (; i < rows.size() && rows[i].a == first && rows[i].b == second; ++i)
      change(rows[i], a, b, of_a, of_b);
    set_motion(a, of_a);
    set_motion(b, of_b);
  }
}

// (6.2)
void set_masses(ContactRow& row, const Mat3& basis, const SolverRoom& room) {
  const InverseMasses k =
      inverse_masses(row, basis, room.bodies[row.a], room.bodies[row.b]);
  row.normal_mass = 1 / k.normal;
  row.tangent_mass = 1 / k.tangent;
}

// Nothing changes its inertia: it is the same about all axes, or nothing turns it
bool is_alike(const Vec3& k) {
  return k.x == 0 || k.y == 0 || k.z == 0 || (k.x == k.y && k.y == k.z);
}

// (6.16) Turns a body, and changes its angular velocity so that the angular momentum
// stays: to second order, by the acceleration that this means at the start. Of turns
// that are too fast for that, the energy stays: the body keeps its spin
void turn(const Vec3& k, const Vec3& angle, Real dt, Quat& orientation, Vec3& omega) {
  if (is_alike(k)) {
    orientation = glm::normalize(rotation_by(angle) * orientation);
    return;
  }
  const Vec3 w = turned_by(glm::conjugate(orientation), omega);
  const Vec3 momentum = w / k;
  const Vec3 gyroscopic = k * glm::cross(momentum, w);
  const Vec3 further = turned_by(orientation, dt * dt / 2 * gyroscopic);
  const bool is_slow = glm::dot(angle, angle) < 1 && glm::dot(further, further) < 1;

  const Vec3 L = turned_by(orientation, momentum);
  const Quat turned = rotation_by(is_slow ? angle + further : angle);
  orientation = glm::normalize(turned * orientation);
  omega = is_slow
              ? turned_by(orientation, k * turned_by(glm::conjugate(orientation), L))
              : turned_by(turned, omega);
}

// The same from one attitude to the next
void turn_ahead(SolverBody& body, Attitude& attitude, Real ahead, Real time) {
  if (is_alike(attitude.inverse_inertia) || time <= attitude.time) return;
  const Vec3 angle = body.turned + ahead * body.angular_velocity - attitude.turned;
  const Vec3 before = body.angular_velocity;
  turn(attitude.inverse_inertia, angle, time - attitude.time, attitude.orientation,
       body.angular_velocity);
  body.free_angular_velocity += body.angular_velocity - before;
  body.inverse_inertia =
      world_inverse_inertia({.orientation = attitude.orientation,
                             .inverse_inertia = attitude.inverse_inertia});
  attitude.turned = body.turned + ahead * body.angular_velocity;
  attitude.time = time;
}

}  // namespace

void prepare(std::span<const RigidBody> bodies, std::span<const PointContact> contacts,
             const SolverSettings& settings, SolverRoom& room) {
  room.bodies.clear();
  room.attitudes.clear();
  room.time = 0;
  for (const RigidBody& body : bodies) {
    room.bodies.push_back(solver_body(body, settings.gravity));
    room.attitudes.push_back({body.orientation, body.inverse_inertia});
  }

  room.rows.clear();
  room.rolling.clear();
  Mat3 basis(0);
  for (const PointContact& c : contacts) {
    if (c.normal != basis[0]) basis = contact_basis(c.normal);
    ContactRow& row = room.rows.emplace_back();
    row.a = c.a;
    row.b = c.b;
    row.normal = c.normal;
    row.arm_a = c.position - c.across / Real(2) - bodies[c.a].position;
    row.arm_b = c.position + c.across / Real(2) - bodies[c.b].position;
    row.friction = c.friction;
    row.gap = -c.depth;
    row.restitution = c.restitution;
    set_masses(row, basis, room);
    if (c.rolling_friction > 0)
      room.rolling.push_back({std::uint32_t(room.rows.size() - 1), c.rolling_friction});
    row.normal_impulse = std::max(glm::dot(c.impulse, c.normal), Real(0));
    row.tangent_impulse = c.impulse - glm::dot(c.impulse, c.normal) * c.normal;
  }
}

void turn_ahead(SolverRoom& room, const ContactRow& row, Real ahead, Real time) {
  for (const std::uint32_t body : {row.a, row.b})
    turn_ahead(room.bodies[body], room.attitudes[body], ahead, time);
}

void update_masses(SolverRoom& room) {
  for (ContactRow& row : room.rows)
    if (room.attitudes[row.a].time > 0 || room.attitudes[row.b].time > 0)
      set_masses(row, contact_basis(row.normal), room);
}

void accelerate(std::span<SolverBody> bodies, Real h) {
  for (SolverBody& body : bodies) {
    body.velocity += h * body.acceleration;
    body.angular_velocity += h * body.angular_acceleration;
    body.free_velocity = body.velocity;
    body.free_angular_velocity = body.angular_velocity;
  }
}

void accelerate_again(std::span<SolverBody> bodies, Real h) {
  for (SolverBody& body : bodies) {
    const Vec3 pushed = body.velocity - body.free_velocity;
    const Vec3 spun = body.angular_velocity - body.free_angular_velocity;
    body.free_velocity = body.velocity + h * body.acceleration;
    body.free_angular_velocity = body.angular_velocity + h * body.angular_acceleration;
    body.velocity = body.free_velocity + pushed;
    body.angular_velocity = body.free_angular_velocity + spun;
  }
}

void warm_start(SolverRoom& room) {
  for_each_row(room, [](const ContactRow& row, const SolverBody& a, const SolverBody& b,
                        Motion& of_a, Motion& of_b) {
    apply(a, row.arm_a, -impulse_of(row), of_a);
    apply(b, row.arm_b, impulse_of(row), of_b);
  });
  for (RollingRow& rolling : room.rolling) rolling.impulse = Vec3(0);
}

void sweep(SolverRoom& room, bool use_pyramid) {
  room.solved += static_cast<long long>(room.rows.size());
  for_each_row(
      room, [&](ContactRow& row, const SolverBody& a, const SolverBody& b, Motion& of_a,
                Motion& of_b) { resolve(row, a, b, of_a, of_b, use_pyramid); });
  for (RollingRow& rolling : room.rolling) resist_rolling(rolling, room);
}

void move(std::span<SolverBody> bodies, Real half_h) {
  for (SolverBody& body : bodies) {
    body.moved += half_h * body.velocity;
    body.turned += half_h * body.angular_velocity;
  }
}

void move_bodies(std::span<RigidBody> bodies, Real dt) {
  for (RigidBody& body : bodies) {
    body.position += dt * body.velocity;
    turn(body.inverse_inertia, dt * body.angular_velocity, dt, body.orientation,
         body.angular_velocity);
    body.force = body.torque = Vec3(0);
  }
}

void finish(const SolverRoom& room, Real dt, std::span<RigidBody> bodies,
            std::span<PointContact> contacts) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SolverBody& solved = room.bodies[i];
    RigidBody& body = bodies[i];
    body.position += solved.moved;
    body.velocity = solved.velocity;
    body.force = body.torque = Vec3(0);

    const Attitude& attitude = room.attitudes[i];
    body.orientation = attitude.orientation;
    body.angular_velocity = solved.angular_velocity;
    turn(body.inverse_inertia, solved.turned - attitude.turned, dt - attitude.time,
         body.orientation, body.angular_velocity);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
    contacts[i].impulse = room.rows[i].phase == ContactPhase::bouncing
                              ? Vec3(0)
                              : impulse_of(room.rows[i]);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
