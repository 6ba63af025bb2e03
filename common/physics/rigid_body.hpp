/// @file
/// Rigid bodies: particles that also turn. Source: chapter 3; thesis, sections 3.3 and
/// 4.3.1, listings 3 and 4.
#pragma once

#include "common/physics/forces.hpp"
#include "common/physics/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A body whose frame has its origin in the centre of mass and its axes along the
/// principal axes. Metres, kilograms, seconds, radians; world frame unless said. A body
/// with both inverses 0 is static: no force moves it.
struct RigidBody {
  Vec3 position{0};              ///< of the centre of mass
  Quat orientation{1, 0, 0, 0};  ///< world from body, of length one
  Vec3 velocity{0};
  Vec3 angular_velocity{0};
  Real inverse_mass = 0;    ///< [1/kg]
  Vec3 inverse_inertia{0};  ///< [1/(kg m²)] of the principal moments, body frame
  Vec3 force{0};            ///< [N] that acts in the next step
  Vec3 torque{0};           ///< [N m] about the centre of mass, in the next step
};

/// A force [N] on the centre of mass.
inline void add_force(RigidBody& body, const Vec3& force) {
  body.force += force;
}

/// A torque [N m].
inline void add_torque(RigidBody& body, const Vec3& torque) {
  body.torque += torque;
}

/// (3.5) A force [N] at a point [m] of the world: Listing 4.
inline void add_force_at_point(RigidBody& body, const Vec3& force, const Vec3& point) {
  body.force += force;
  body.torque += glm::cross(point - body.position, force);
}

/// (3.1) Where a point of the body frame [m] is in the world.
inline Vec3 world_point(const RigidBody& body, const Vec3& in_body_frame) {
  return body.position + body.orientation * in_body_frame;
}

/// Velocity [m/s] of the body's matter at a point [m] of the world.
inline Vec3 velocity_at(const RigidBody& body, const Vec3& point) {
  return body.velocity + glm::cross(body.angular_velocity, point - body.position);
}

/// (3.12) Inverse inertia tensor [1/(kg m²)] in the world frame. Derived when it is
/// asked for, so that it is never stale.
inline Mat3 world_inverse_inertia(const RigidBody& body) {
  const Mat3 R = matrix_of(body.orientation);
  const Vec3& k = body.inverse_inertia;
  return Mat3(k.x * R[0], k.y * R[1], k.z * R[2]) * glm::transpose(R);
}

/// (1.10) Takes speed away, linear and angular: `linear` and `angular` are the shares,
/// in (0, 1], that are to be left after one second.
inline void damp(RigidBody& body, Real linear, Real angular, Real dt) {
  body.velocity *= damping_factor(linear, dt);
  body.angular_velocity *= damping_factor(angular, dt);
}

/// How a body stands and turns, for a rotation method; and back.
inline Rotation rotation_of(const RigidBody& body) {
  return {body.orientation,
          turned_by(glm::conjugate(body.orientation), body.angular_velocity)};
}
inline void set_rotation(RigidBody& body, const Rotation& r) {
  body.orientation = r.q;
  body.angular_velocity = turned_by(r.q, r.omega);
}

/// What follows is for measuring: in double, whatever the precision, so that it adds no
/// rounding of its own. Mass [kg]; of a static body 0.
inline double mass_of(const RigidBody& body) {
  return body.inverse_mass > 0 ? 1 / static_cast<double>(body.inverse_mass) : 0;
}

/// (3.13) Angular momentum [kg m²/s] about the centre of mass, world frame. About axes
/// that nothing turns a body has none.
inline glm::dvec3 spin_of(const RigidBody& body) {
  const glm::dquat q(body.orientation);
  const glm::dvec3 omega = glm::conjugate(q) * glm::dvec3(body.angular_velocity);
  glm::dvec3 L(0);
  for (glm::length_t i = 0; i < 3; ++i)
    if (body.inverse_inertia[i] > 0)
      L[i] = omega[i] / static_cast<double>(body.inverse_inertia[i]);
  return q * L;
}

/// The same about a point [m] of the world: turn and orbit.
inline glm::dvec3 angular_momentum_about(const RigidBody& body,
                                         const glm::dvec3& point) {
  const glm::dvec3 arm = glm::dvec3(body.position) - point;
  return spin_of(body) + glm::cross(arm, mass_of(body) * glm::dvec3(body.velocity));
}

/// (3.15) Kinetic energy [J], of motion and turn.
inline double kinetic_energy(const RigidBody& body) {
  const glm::dvec3 v(body.velocity), omega(body.angular_velocity);
  return (mass_of(body) * glm::dot(v, v) + glm::dot(omega, spin_of(body))) / 2;
}

/// A step of dt [s]: semi-implicit Euler for the centre of mass, `method` (see
/// rotation.hpp) for the rotation. Force and torque act through the whole step, then
/// they are gone.
inline void integrate(RigidBody& body, const auto& method, Real dt) {
  body.velocity += dt * newton(body.force, body.inverse_mass);
  body.position += dt * body.velocity;

  // A body without inverse inertia turns as it is told to, about a fixed axis
  if (body.inverse_inertia == Vec3(0)) {
    body.orientation =
        glm::normalize(rotation_by(dt * body.angular_velocity) * body.orientation);
  } else {
    const auto torque = [&](const Quat&, Real) { return body.torque; };
    Rotation r = rotation_of(body);
    method(r, Vec3(1) / body.inverse_inertia, torque, Real(0), dt);
    set_rotation(body, r);
  }
  body.force = body.torque = Vec3(0);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
