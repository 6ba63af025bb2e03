/// @file
/// Rotation as that of a ball, and what two of the axes differ from it. Source: chapter
/// 3; J. Touma, J. Wisdom, Lie-Poisson integrators for rigid body dynamics in the solar
/// system, Astronomical Journal 107 (1994).
#pragma once

#include <array>

#include "common/physics/rotation_momentum.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Equation (3.37): every body turns as a ball of its second moment does, and besides
/// about its first and third axes, as far as those differ. Second order, symplectic,
/// reversible; exact for balls, and for symmetric bodies where the second moment is one
/// of the two equal ones, as it is in ascending order.
inline void rotor_splitting(Rotation& r, const Vec3& I, const auto& torque, Real t,
                            Real dt) {
  const auto differ_about = [&](int axis, Real h) {
    Vec3 angle(0);
    angle[axis] = h * (1 - I[axis] / I.y) * r.omega[axis];
    turn(r, I, rotation_by(angle));
  };
  kick(r, I, torque, t, dt / 2);
  differ_about(2, dt / 2);
  differ_about(0, dt);
  turn(r, I, rotation_by(dt / I.y * I * r.omega));  // the ball's, about L itself
  differ_about(2, dt / 2);
  kick(r, I, torque, t + dt, dt / 2);
}

/// Equation (3.38): five steps, the middle one backwards. Fourth order, symplectic,
/// reversible. Source: M. Suzuki, Fractal decomposition of exponential operators,
/// Physics Letters A 146 (1990).
inline void rotor_splitting_4(Rotation& r, const Vec3& I, const auto& torque, Real t,
                              Real dt) {
  constexpr Real s = static_cast<Real>(0.4144907717943757);  // 1 / (4 - 4^(1/3))
  constexpr std::array<Real, 5> shares{s, s, 1 - 4 * s, s, s};
  for (const Real share : shares) {
    rotor_splitting(r, I, torque, t, share * dt);
    t += share * dt;
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
