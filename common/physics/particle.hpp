/// @file
/// Particles: points with a mass. Many of them lie one after the other in a flat array,
/// three numbers each, so that an integrator can run straight through.
/// Source: chapter 1.
#pragma once

#include <cstddef>
#include <span>

#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// The vector of particle i in a flat array of three numbers a particle.
inline Vec3 at(std::span<const Real> q, std::size_t i) {
  return {q[3 * i], q[3 * i + 1], q[3 * i + 2]};
}

/// Writes the vector of particle i.
inline void put(std::span<Real> q, std::size_t i, const Vec3& value) {
  q[3 * i] = value.x;
  q[3 * i + 1] = value.y;
  q[3 * i + 2] = value.z;
}

/// A state with room for n particles, all at rest at the origin.
inline State particles(std::size_t n) {
  const std::vector<Real> zero(3 * n, Real(0));
  return {.x = zero, .v = zero, .a = zero};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
