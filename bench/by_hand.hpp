/// @file
/// What to measure ourselves against: for each method one loop over flat arrays,
/// written for nothing but a = -omega² x, in vectors as wide as the processor's. The
/// arithmetic is that of common/physics, rounding by rounding. The size of the arrays
/// is a multiple of the width.
#pragma once

#if __has_include(<experimental/simd>)
#define TIMESTEP_HAS_SIMD
#include <span>

#include <experimental/simd>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench::by_hand {

using Wide = std::experimental::native_simd<Real>;
constexpr std::experimental::element_aligned_tag k_aligned;

inline void semi_implicit_euler(std::span<Real> xs, std::span<Real> vs, Real omega2,
                                Real dt) {
  for (std::size_t i = 0; i < xs.size(); i += Wide::size()) {
    Wide x(&xs[i], k_aligned), v(&vs[i], k_aligned);
    v += -omega2 * x * dt;
    x += v * dt;
    x.copy_to(&xs[i], k_aligned);
    v.copy_to(&vs[i], k_aligned);
  }
}

inline void velocity_verlet(std::span<Real> xs, std::span<Real> vs, std::span<Real> as,
                            Real omega2, Real dt) {
  for (std::size_t i = 0; i < xs.size(); i += Wide::size()) {
    Wide x(&xs[i], k_aligned), v(&vs[i], k_aligned), a(&as[i], k_aligned);
    v += a * (dt / 2);
    x += v * dt;
    a = -omega2 * x;
    v += a * (dt / 2);
    x.copy_to(&xs[i], k_aligned);
    v.copy_to(&vs[i], k_aligned);
    a.copy_to(&as[i], k_aligned);
  }
}

inline void position_verlet(std::span<Real> xs, std::span<Real> vs, Real omega2,
                            Real dt) {
  for (std::size_t i = 0; i < xs.size(); i += Wide::size()) {
    Wide x(&xs[i], k_aligned), v(&vs[i], k_aligned);
    x += v * (dt / 2);
    v += -omega2 * x * dt;
    x += v * (dt / 2);
    x.copy_to(&xs[i], k_aligned);
    v.copy_to(&vs[i], k_aligned);
  }
}

inline void rk4(std::span<Real> xs, std::span<Real> vs, Real omega2, Real dt) {
  for (std::size_t i = 0; i < xs.size(); i += Wide::size()) {
    Wide x(&xs[i], k_aligned), v(&vs[i], k_aligned);
    const Wide a = -omega2 * x;
    const Wide x2 = x + dt / 2 * v, v2 = v + dt / 2 * a, a2 = -omega2 * x2;
    const Wide x3 = x + dt / 2 * v2, v3 = v + dt / 2 * a2, a3 = -omega2 * x3;
    const Wide x4 = x + dt * v3, v4 = v + dt * a3, a4 = -omega2 * x4;
    x += dt / 6 * (v + 2 * (v2 + v3) + v4);
    v += dt / 6 * (a + 2 * (a2 + a3) + a4);
    x.copy_to(&xs[i], k_aligned);
    v.copy_to(&vs[i], k_aligned);
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench::by_hand
#endif
