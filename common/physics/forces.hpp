/// @file
/// The forces of chapter 1 on one particle, in newtons, world frame, and Newton's law
/// that turns their sum into an acceleration. Source: chapter 1; thesis, sections 2.1
/// and 4.3.1.
#pragma once

#include <cmath>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (1.1) Newton's second law: acceleration [m/s²] from the sum of the forces [N] and
/// the inverse mass [1/kg]. An immovable particle has inverse mass 0.
inline Vec3 newton(const Vec3& force, Real inverse_mass) {
  return force * inverse_mass;
}

/// (1.6) Weight of a mass m [kg] in the field g [m/s²].
inline Vec3 weight(Real m, const Vec3& g) {
  return m * g;
}

/// (1.7) Spring of stiffness k [N/m] and length 0 at rest, that pulls x to the anchor
/// [m].
inline Vec3 spring(Real k, const Vec3& x, const Vec3& anchor) {
  return -k * (x - anchor);
}

/// (1.8) Linear drag, c [kg/s]: slow or small things in something thick.
inline Vec3 linear_drag(Real c, const Vec3& v) {
  return -c * v;
}

/// (1.9) Quadratic drag, k = ρ C_d A / 2 [kg/m]: balls in air.
inline Vec3 quadratic_drag(Real k, const Vec3& v) {
  return -k * glm::length(v) * v;
}

/// (1.10) Damping as the thesis has it (Listing 3): the factor on v in a step of dt [s]
/// when the share `damping` of it, in (0, 1], is to be left after one second.
inline Real damping_factor(Real damping, Real dt) {
  return std::pow(damping, dt);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
