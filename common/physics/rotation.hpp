/// @file
/// How a rigid body turns: its state, what it keeps, and the common form of the methods
/// that move it. The body frame has its origin in the centre of mass and its axes along
/// the principal axes, so that the inertia tensor is three numbers. Source: chapter 3.
#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

#include "common/physics/quaternion.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// How a body stands and turns.
struct Rotation {
  Quat q{1, 0, 0, 0};  ///< orientation, world from body, of length one
  Vec3 omega{0};       ///< angular velocity [rad/s], body frame
};

/// (3.13) Angular momentum [kg m²/s], world frame. I: principal moments [kg m²].
inline Vec3 angular_momentum(const Rotation& r, const Vec3& I) {
  return r.q * (I * r.omega);
}

/// (3.14) What the shape of a body does to its rotation: (I3 - I2) / I1 and so on. All
/// 0 for a sphere and a cube; within -1 to 1 for every body that there can be.
inline Vec3 shape_ratios(const Vec3& I) {
  return Vec3(I.z - I.y, I.x - I.z, I.y - I.x) / I;
}

/// (3.14) The gyroscopic term I⁻¹ (omega x I omega) [rad/s²], with c = shape_ratios(I).
inline Vec3 gyroscopic_term(const Vec3& c, const Vec3& omega) {
  return c * Vec3(omega.y * omega.z, omega.z * omega.x, omega.x * omega.y);
}

/// How the gyroscopic term changes with omega: a column for each component.
inline Mat3 gyroscopic_slope(const Vec3& c, const Vec3& w) {
  return Mat3(0, c.y * w.z, c.z * w.y, c.x * w.z, 0, c.z * w.x, c.x * w.y, c.y * w.x,
              0);
}

/// (3.14) Euler's equations: the angular acceleration [rad/s²] under a torque tau [N
/// m], all in the body frame.
inline Vec3 euler_equations(const Vec3& omega, const Vec3& I, const Vec3& tau) {
  return tau / I - gyroscopic_term(shape_ratios(I), omega);
}

/// (3.15) Energy of the rotation [J].
inline Real rotational_energy(const Rotation& r, const Vec3& I) {
  return glm::dot(r.omega, I * r.omega) / 2;
}

/// The torque [N m], world frame, on a body that stands as q says, at a time t [s].
using Torque = std::function<Vec3(const Quat& q, Real t)>;

/// Thrown by a method whose equation has no solution at this dt. `what()` names both.
struct Unsolved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Changes r from time t to t + dt [s]. The methods are written for every type of
/// `torque` that can be called as a Torque.
using RotationStep = void (*)(Rotation& r, const Vec3& I, const Torque& torque, Real t,
                              Real dt);

/// A method with its price and its character.
struct RotationMethod {
  std::string_view name, summary;
  RotationStep step;
  int evaluations;  ///< of the torque, in one step
  int order;        ///< p: the error after a fixed time shrinks as dt^p; 0: it does not
  bool keeps_momentum = false;  ///< L, without torque, to rounding
  bool keeps_energy = false;    ///< without torque, to rounding
  bool reversible = false;      ///< a step back with -dt undoes a step
  bool symplectic = false;
};

/// The torque from the world frame to the body's.
inline Vec3 in_body(const Quat& q, const Vec3& world) {
  return glm::conjugate(q) * world;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
