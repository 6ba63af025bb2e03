/// @file
/// Rotation by Runge-Kutta methods: several looks at the rates within a step. Source:
/// chapter 3.
#pragma once

#include "common/physics/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (3.23): the midpoint method, with the orientation turned by (3.3). Second
/// order.
inline void explicit_midpoint_su2(Rotation& r, const Vec3& I, const auto& torque,
                                  Real t, Real dt) {
  // Half an Euler step to look at the rates there
  const Vec3 alpha = euler_equations(r.omega, I, in_body(r.q, torque(r.q, t)));
  const Rotation middle{r.q * rotation_by(dt / 2 * r.omega), r.omega + dt / 2 * alpha};

  // The step with those
  const Vec3 tau = in_body(middle.q, torque(middle.q, t + dt / 2));
  r.omega += dt * euler_equations(middle.omega, I, tau);
  r.q = glm::normalize(r.q * rotation_by(dt * middle.omega));
}

/// Equation (3.27): the classical method (2.15) on the seven numbers of q and omega,
/// then q back to length one. Fourth order.
inline void rk4(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  // (3.2), (3.14) The rates of q and omega
  const auto rates = [&](const Quat& q, const Vec3& omega, Real when) {
    const Quat unit = glm::normalize(q);
    const Vec3 tau = in_body(unit, torque(unit, when));
    return Rotation{q * Quat(0, omega) * Real(0.5), euler_equations(omega, I, tau)};
  };
  const auto ahead = [&](const Rotation& k, Real h) {
    return rates(r.q + k.q * h, r.omega + k.omega * h, t + h);
  };

  // (2.15) At the start, twice half-way, at the end; then Simpson's weights
  const Rotation k1 = rates(r.q, r.omega, t);
  const Rotation k2 = ahead(k1, dt / 2);
  const Rotation k3 = ahead(k2, dt / 2);
  const Rotation k4 = ahead(k3, dt);
  r.q = glm::normalize(r.q + (k1.q + (k2.q + k3.q) * Real(2) + k4.q) * (dt / 6));
  r.omega += dt / 6 * (k1.omega + Real(2) * (k2.omega + k3.omega) + k4.omega);
}

/// (3.28) How fast the vector phi [rad] of a rotation exp(phi) must change so that the
/// body turns at w [rad/s, its own frame].
inline Vec3 rate_of_rotation_vector(const Vec3& phi, const Vec3& w) {
  const Real a = glm::length(phi);
  const Real d = a > 0 ? (1 - a / 2 / std::tan(a / 2)) / (a * a) : Real(1) / 12;
  const Vec3 phi_w = glm::cross(phi, w);
  return w + phi_w / Real(2) + d * glm::cross(phi, phi_w);
}

/// Equation (3.28): the classical method on the vector of the rotation since the start
/// of the step, and on L. Fourth order; keeps L without torque. Source: H. Munthe-Kaas,
/// High order Runge-Kutta methods on manifolds, Applied Numerical Mathematics 29
/// (1999).
inline void rkmk4(Rotation& r, const Vec3& I, const auto& torque, Real t, Real dt) {
  // What changes since the start of the step, in the body's frame at the start
  struct Change {
    Vec3 phi, L;
  };
  const Vec3 L = I * r.omega;
  const auto ahead = [&](const Change& k, Real h) {
    const Quat f = rotation_by(h * k.phi);
    const Vec3 w = in_body(f, L + h * k.L) / I;
    return Change{rate_of_rotation_vector(h * k.phi, w),
                  in_body(r.q, torque(r.q * f, t + h))};
  };

  // (2.15) At the start, twice half-way, at the end; then Simpson's weights
  const Change k1 = ahead({Vec3(0), Vec3(0)}, 0);
  const Change k2 = ahead(k1, dt / 2);
  const Change k3 = ahead(k2, dt / 2);
  const Change k4 = ahead(k3, dt);
  const Quat f = rotation_by(dt / 6 * (k1.phi + Real(2) * (k2.phi + k3.phi) + k4.phi));
  const Vec3 kicked = L + dt / 6 * (k1.L + Real(2) * (k2.L + k3.L) + k4.L);
  r.q = glm::normalize(r.q * f);
  r.omega = in_body(f, kicked) / I;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
