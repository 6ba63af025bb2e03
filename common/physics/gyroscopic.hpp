/// @file
/// Rotation as game engines do it: the angular velocity is kept, and the gyroscopic
/// term is left out, or added in one of three ways. Source: chapter 3.
#pragma once

#include "common/physics/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (3.16): the thesis's Listing 3. Without torque the angular velocity stands
/// still in the world, which is wrong for every body but spheres and cubes, however
/// small dt is. Millington's cyclone and qu3e do the same.
inline void listing_3(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  // (3.16) The world's inertia turns the torque into an acceleration
  Vec3 omega = r.q * r.omega;
  omega += dt * (r.q * (in_body(r.q, torque(r.q, t)) / I));

  // (3.4) Add, normalise
  r.q = add_and_normalise(r.q, omega, dt);
  r.omega = in_body(r.q, omega);
}

/// As listing_3, but turned by (3.3): what is wrong then is the missing term alone.
/// omega is the axis of the turn, so it stands still in the body's frame, too.
inline void constant_omega(Rotation& r, const Vec3& I, const auto& torque, Real t,
                           Real dt) {
  r.omega += dt * in_body(r.q, torque(r.q, t)) / I;
  r.q = glm::normalize(r.q * rotation_by(dt * r.omega));
}

/// Equation (3.17): Euler's equations by explicit Euler. First order. Without torque
/// the energy grows in every step, by dt²/2 alpha · I alpha.
inline void explicit_gyroscopic(Rotation& r, const Vec3& I, const auto& torque, Real t,
                                Real dt) {
  r.omega += dt * euler_equations(r.omega, I, in_body(r.q, torque(r.q, t)));
  r.q = add_and_normalise_in_body(r.q, r.omega, dt);
}

/// (3.18) The angular velocity w [rad/s, body frame] at the end of a step of dt [s]
/// without torque, by so many of Newton's steps on w + dt c (w2 w3, w3 w1, w1 w2) =
/// omega.
inline Vec3 implicit_gyroscopic_velocity(const Vec3& omega, const Vec3& I, Real dt,
                                         int newton_steps) {
  const Vec3 c = shape_ratios(I);
  Vec3 w = omega;
  for (int i = 0; i < newton_steps; ++i) {
    const Vec3 f = w - omega + dt * gyroscopic_term(c, w);
    w -= glm::inverse(Mat3(1) + dt * gyroscopic_slope(c, w)) * f;
  }
  return w;
}

/// Equation (3.18): the gyroscopic term as it is at the end of the step, by one step of
/// Newton's method. First order. Without torque the energy falls. Bullet and Box3D do
/// this. Source: E. Catto, Physics for Game Programmers: Numerical Methods (GDC 2015).
inline void implicit_gyroscopic(Rotation& r, const Vec3& I, const auto& torque, Real t,
                                Real dt) {
  r.omega += dt * in_body(r.q, torque(r.q, t)) / I;
  r.omega = implicit_gyroscopic_velocity(r.omega, I, dt, 1);
  r.q = add_and_normalise_in_body(r.q, r.omega, dt);
}

/// (3.20) The angular velocity [rad/s, body frame] that explicit Euler leads to without
/// torque, made shorter so that |L| stays.
inline Vec3 rescaled_velocity(const Vec3& omega, const Vec3& I, Real dt) {
  const Vec3 longer = omega - dt * gyroscopic_term(shape_ratios(I), omega);
  const Real length = glm::length(I * longer);
  return length > 0 ? glm::length(I * omega) / length * longer : omega;
}

/// Equation (3.20): as explicit_gyroscopic, with the length of the angular momentum put
/// back. First order. Cannot explode, but drifts from one kind of motion to another.
/// Jolt does this where it is asked to.
inline void explicit_rescaled(Rotation& r, const Vec3& I, const auto& torque, Real t,
                              Real dt) {
  r.omega = rescaled_velocity(r.omega, I, dt);
  r.omega += dt * in_body(r.q, torque(r.q, t)) / I;
  r.q = glm::normalize(r.q * rotation_by(dt * r.omega));
}

}  // namespace timestep::inline TIMESTEP_PRECISION
