/// @file
/// Methods that turn a body at work in the tests of chapter 3, in the precision at
/// hand. What is measured of them is computed in double.
#pragma once

#include <algorithm>
#include <limits>
#include <string_view>

#include "common/physics/exact_top.hpp"
#include "common/physics/rotations.hpp"
#include "tests/catch.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off
constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

inline const RotationMethod& rotation_method(std::string_view name) {
  const RotationMethod* found = find_rotation_method(name);
  REQUIRE(found != nullptr);
  return *found;
}

inline Vec3 no_torque(const Quat&, Real) {
  return Vec3(0);
}

/// A field B = (0, 0, -2) turns a needle along (1, 0, 1) of the body: the torque has a
/// potential.
inline Vec3 compass(const Quat& q, Real) {
  return glm::cross(q * Vec3(1, 0, 1), Vec3(0, 0, -2));
}

/// As compass, in a field that grows with time.
inline Vec3 stirred_compass(const Quat& q, Real t) {
  return glm::cross(q * Vec3(1, 0, 1), Vec3(t, 0, -2));
}

/// Unequal moments and a start that turns about all axes, at |omega| = 1.34.
inline Vec3 asymmetric() {
  return {1, 2, Real(2.5)};
}
inline Rotation tumbling() {
  return {glm::normalize(Quat(2, 1, -1, 3)), {Real(0.4), 1, Real(0.8)}};
}

/// The method after n steps of dt from a time 0.
inline Rotation turned(const RotationMethod& method, Rotation r, const Vec3& I,
                       const Torque& torque, double dt, int n) {
  for (int i = 0; i < n; ++i) method.step(r, I, torque, Real(i) * Real(dt), Real(dt));
  return r;
}

inline exact::Turning in_double(const Rotation& r) {
  return {glm::dquat(r.q), glm::dvec3(r.omega)};
}

inline glm::dvec3 momentum_of(const Rotation& r, const Vec3& I) {
  return exact::angular_momentum(in_double(r), glm::dvec3(I));
}

inline double energy_of(const Rotation& r, const Vec3& I) {
  return exact::rotational_energy(in_double(r), glm::dvec3(I));
}

inline bool is_finite(const Rotation& r) {
  return std::isfinite(glm::dot(r.q, r.q) + glm::dot(r.omega, r.omega));
}

inline bool same_bits(const Rotation& a, const Rotation& b) {
  return a.q == b.q && a.omega == b.omega;
}

/// How far energy and momentum have been from their values at the start, as shares.
struct Drift {
  double energy = 0, momentum = 0, momentum_length = 0;
};

inline Drift drift(const RotationMethod& method, Rotation r, const Vec3& I, double dt,
                   int n) {
  const double E = energy_of(r, I);
  const glm::dvec3 L = momentum_of(r, I);
  const Torque none = no_torque;
  Drift most;
  for (int i = 0; i < n; ++i) {
    method.step(r, I, none, 0, Real(dt));
    const glm::dvec3 now = momentum_of(r, I);
    const double longer = glm::length(now) / glm::length(L) - 1;
    most.energy = std::max(most.energy, std::abs(energy_of(r, I) / E - 1));
    most.momentum = std::max(most.momentum, glm::length(now - L) / glm::length(L));
    most.momentum_length = std::max(most.momentum_length, std::abs(longer));
  }
  return most;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
