/// @file
/// Schemes at work in the tests of chapter 2, in the precision at hand.
#pragma once

#include <limits>
#include <string_view>

#include "common/physics/schemes.hpp"
#include "common/physics/systems.hpp"
#include "tests/catch.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off
constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

inline const Scheme& scheme(std::string_view name) {
  const Scheme* found = find_scheme(name);
  REQUIRE(found != nullptr);
  return *found;
}

/// Störmer's velocity is a difference of places: a rounding of x counts 1/dt times.
inline bool is_stormer(const Scheme& s) {
  return s.name.starts_with("stormer");
}

/// One coordinate and its rate.
inline State one(double x, double v) {
  return {.x = {Real(x)}, .v = {Real(v)}, .a = {Real(0)}};
}

/// A pendulum with g = length.
inline void unit_pendulum(std::span<const Real> x, std::span<const Real>, Real,
                          std::span<Real> a) {
  a[0] = pendulum(1, 1, x[0]);
}

/// An oscillator with omega = 1.
inline void unit_spring(std::span<const Real> x, std::span<const Real>, Real,
                        std::span<Real> a) {
  a[0] = -x[0];
}

/// A spring of stiffness k and a damper c on one kilogram.
inline Acceleration spring_and_damper(Real k, Real c) {
  return [k, c](auto x, auto v, Real, auto a) { a[0] = -k * x[0] - c * v[0]; };
}

/// The scheme after n steps from the start.
inline Integration run(const Scheme& s, const Acceleration& acceleration,
                       const State& start, double dt, int n) {
  Integration now = begin(s, acceleration, start, Real(dt));
  for (int i = 0; i < n; ++i) advance(now);
  return now;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
