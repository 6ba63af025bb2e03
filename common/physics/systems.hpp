/// @file
/// The systems of chapter 2: accelerations of orbits, pendulums, and masses on springs.
/// Source: chapter 2.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (2.22) Newton's gravity at x [m] from a body at the origin with GM = mu [m³/s²].
inline Vec3 gravity_towards_origin(Real mu, const Vec3& x) {
  const Real r2 = glm::dot(x, x);
  return x * (-mu / (r2 * std::sqrt(r2)));
}

/// (2.23) Angular acceleration [rad/s²] of a pendulum at an angle theta [rad] from
/// hanging; g [m/s²], length [m].
inline Real pendulum(Real g, Real length, Real theta) {
  return -g / length * std::sin(theta);
}

/// Two point masses [kg] on massless rods [m] in the field g [m/s²].
struct DoublePendulum {
  Real m1, m2, l1, l2, g;
};

/// (2.24) Angular accelerations [rad/s²] from the angles from hanging theta [rad] and
/// their rates omega [rad/s]: Lagrange's equations, solved for the two.
inline void double_pendulum(const DoublePendulum& p, std::span<const Real> theta,
                            std::span<const Real> omega, std::span<Real> alpha) {
  const auto [m1, m2, l1, l2, g] = p;
  const Real s = std::sin(theta[0] - theta[1]);
  const Real c = std::cos(theta[0] - theta[1]);
  const Real M = m1 + m2;

  // M l1 alpha1 + m2 l2 c alpha2 = f1,  l1 c alpha1 + l2 alpha2 = f2
  const Real f1 = -M * g * std::sin(theta[0]) - m2 * l2 * s * omega[1] * omega[1];
  const Real f2 = -g * std::sin(theta[1]) + l1 * s * omega[0] * omega[0];
  const Real determinant = m1 + m2 * s * s;  // M - m2 c², without cancellation
  alpha[0] = (f1 - m2 * c * f2) / (l1 * determinant);
  alpha[1] = (M * f2 - c * f1) / (l2 * determinant);
}

/// Kinetic and potential energy [J] of the two, 0 where they hang and rest at the
/// pivot.
inline Real energy(const DoublePendulum& p, std::span<const Real> theta,
                   std::span<const Real> omega) {
  const auto [m1, m2, l1, l2, g] = p;
  const Real u1 = l1 * omega[0];
  const Real u2 = l2 * omega[1];
  const Real kinetic =
      (m1 * u1 * u1
       + m2 * (u1 * u1 + u2 * u2 + 2 * u1 * u2 * std::cos(theta[0] - theta[1])))
      / 2;
  return kinetic - (m1 + m2) * g * l1 * std::cos(theta[0])
         - m2 * g * l2 * std::cos(theta[1]);
}

/// A spring of a rest length [m] and a stiffness [N/m] between particles i and j.
struct SpringBetween {
  std::size_t i, j;
  Real length, stiffness;
};

/// (2.25) The force [N] that it puts on particle i; particle j feels the opposite.
inline Vec3 force_on_first(const SpringBetween& s, std::span<const Real> x) {
  const Vec3 d = at(x, s.j) - at(x, s.i);
  const Real l = glm::length(d);
  return s.stiffness * (l - s.length) / l * d;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
