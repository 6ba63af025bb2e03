/// @file
/// Rotation by angular momentum: without torque L stands still in the world, so these
/// methods turn the body and let L be. Torque is a kick to L. Source: chapter 3.
#pragma once

#include "common/physics/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (3.19) L grows by dt tau while the body stands still.
inline void kick(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  r.omega += dt * in_body(r.q, torque(r.q, t)) / I;
}

/// (3.19) Turns the body by f, a rotation in its own frame, while L stands still.
inline void turn(Rotation& r, const Vec3& I, const Quat& f) {
  const Vec3 L = I * r.omega;
  r.q = glm::normalize(r.q * f);
  r.omega = in_body(f, L) / I;
}

/// Equation (3.19): turn with the velocity that belongs to L at the start. First order;
/// the energy drifts upwards. Source: D. Baraff, Physically Based Modeling (SIGGRAPH
/// course, 1997).
inline void momentum(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  kick(r, I, torque, t, dt);
  turn(r, I, rotation_by(dt * r.omega));
}

/// Equation (3.21): turn with the velocity that is to be expected half-way. Second
/// order. Source: S. R. Buss, Accurate and Efficient Simulation of Rigid-Body
/// Rotations, Journal of Computational Physics 164 (2000), section 4.
inline void buss_second_order(Rotation& r, const Vec3& I, const auto& torque, Real t,
                              Real dt) {
  const Vec3 alpha = euler_equations(r.omega, I, in_body(r.q, torque(r.q, t)));
  const Quat f = rotation_by(dt * (r.omega + dt / 2 * alpha));

  kick(r, I, torque, t, dt / 2);
  turn(r, I, f);
  kick(r, I, torque, t + dt, dt / 2);
}

/// Equation (3.22): with a term for the turning of the axis within the step. Second
/// order. Source: as buss_second_order.
inline void buss(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  const Vec3 alpha = euler_equations(r.omega, I, in_body(r.q, torque(r.q, t)));
  const Vec3 axis_turns = dt * dt / 12 * glm::cross(alpha, r.omega);
  const Quat f = rotation_by(dt * (r.omega + dt / 2 * alpha + axis_turns));

  kick(r, I, torque, t, dt / 2);
  turn(r, I, f);
  kick(r, I, torque, t + dt, dt / 2);
}

/// (3.24) The velocity w [rad/s, body frame at the start] that belongs to L after half
/// of the turn dt w: the root of I w = exp(-dt w / 2) I omega. Throws Unsolved, which
/// no body was seen to need up to |omega| dt = 2.
Vec3 velocity_half_way(const Vec3& omega, const Vec3& I, Real dt);

/// Equation (3.24): turn with the velocity that belongs to L half-way through that
/// turn. Second order, reversible. Source: P. Krysl, L. Endres, Explicit Newmark/Verlet
/// algorithm for time integration of the rotational dynamics of rigid bodies,
/// International Journal for Numerical Methods in Engineering 62 (2005).
inline void lie_midpoint(Rotation& r, const Vec3& I, const auto& torque, Real t,
                         Real dt) {
  kick(r, I, torque, t, dt / 2);
  turn(r, I, rotation_by(dt * velocity_half_way(r.omega, I, dt)));
  kick(r, I, torque, t + dt, dt / 2);
}

/// Equation (3.25): as if the body turned about one principal axis after the other,
/// each of which is exact: 1, 2, 3, 2, 1. Second order, symplectic, reversible. Source:
/// R. I. McLachlan, Explicit Lie-Poisson integration and the Euler equations, Physical
/// Review Letters 71 (1993); S. Reich, Physica D 76 (1994).
inline void splitting(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  const auto turn_about = [&](int axis, Real h) {
    Vec3 angle(0);
    angle[axis] = h * r.omega[axis];
    turn(r, I, rotation_by(angle));
  };
  kick(r, I, torque, t, dt / 2);
  turn_about(0, dt / 2);
  turn_about(1, dt / 2);
  turn_about(2, dt);
  turn_about(1, dt / 2);
  turn_about(0, dt / 2);
  kick(r, I, torque, t + dt, dt / 2);
}

/// (3.26) The turn of a step as a quaternion (a, b): the root of
/// a b + c (b2 b3, b3 b1, b1 b2) = dt omega / 2, with c the shape's ratios. Throws
/// Unsolved: about a principal axis there is none above |omega| dt = 1, about others
/// none from 1 to 1.4 on.
Quat moser_veselov_turn(const Vec3& omega, const Vec3& I, Real dt);

/// Equation (3.26): the discrete body of J. Moser and A. P. Veselov (Communications in
/// Mathematical Physics 139, 1991), in the form of R. I. McLachlan and A. Zanna (2005).
/// Second order, symplectic, reversible; keeps L and the energy, both to rounding.
inline void discrete_moser_veselov(Rotation& r, const Vec3& I, const auto& torque,
                                   Real t, Real dt) {
  kick(r, I, torque, t, dt / 2);
  turn(r, I, moser_veselov_turn(r.omega, I, dt));
  kick(r, I, torque, t + dt, dt / 2);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
