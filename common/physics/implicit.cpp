#include "common/physics/implicit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/physics/euler.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Vector = std::vector<Real>;
constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off

Real largest(const Vector& r) {
  Real most = 0;
  for (const Real each : r) most = std::max(most, std::abs(each));
  return most;
}

// Solves A y = r by Gauss, rows exchanged so that the pivot is the largest.
Vector solution(std::vector<Vector> A, Vector r) {
  const std::size_t d = r.size();
  for (std::size_t i = 0; i < d; ++i) {
    std::size_t pivot = i;
    for (std::size_t j = i + 1; j < d; ++j)
      if (std::abs(A[j][i]) > std::abs(A[pivot][i])) pivot = j;
    std::swap(A[i], A[pivot]);
    std::swap(r[i], r[pivot]);
    for (std::size_t j = i + 1; j < d; ++j) {
      const Real factor = A[j][i] / A[i][i];
      for (std::size_t k = i; k < d; ++k) A[j][k] -= factor * A[i][k];
      r[j] -= factor * r[i];
    }
  }
  for (std::size_t i = d; i-- > 0;) {
    for (std::size_t k = i + 1; k < d; ++k) r[i] -= A[i][k] * r[k];
    r[i] /= A[i][i];
  }
  return r;
}

// The end of a step as the root of one equation for its velocity w:
// g(w) = v + a(x + drift w, w, t) dt - w = 0
struct End {
  const Vector &x, &v;
  const Acceleration& acceleration;
  Real t, dt, drift;

  Vector place(const Vector& w) const {
    Vector y = x;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += drift * w[i];
    return y;
  }

  Vector g(const Vector& w) const {
    Vector a(w.size());
    acceleration(place(w), w, t, a);
    for (std::size_t i = 0; i < w.size(); ++i) a[i] = (v[i] - w[i]) + a[i] * dt;
    return a;
  }

  // -dg/dw, a column from a difference in each component of w. The step is a share of
  // the largest term: sqrt(u) balances rounding against curvature. It must also move
  // the place by many times what that rounds.
  std::vector<Vector> slope(const Vector& w, const Vector& g_w) const {
    const std::size_t d = w.size();
    Real step = std::sqrt(k_u)
                * std::max({largest(w), largest(v), largest(g_w), std::sqrt(k_u)});
    if (drift != 0) step = std::max(step, 64 * k_u * largest(x) / std::abs(drift));
    std::vector<Vector> A(d, Vector(d));
    Vector moved = w;
    for (std::size_t j = 0; j < d; ++j) {
      moved[j] = w[j] + step;
      const Real moved_by = moved[j] - w[j];
      const Vector g_moved = g(moved);
      for (std::size_t i = 0; i < d; ++i) A[i][j] = (g_w[i] - g_moved[i]) / moved_by;
      moved[j] = w[j];
    }
    return A;
  }
};

Vector moved(Vector w, Real share, const Vector& correction) {
  for (std::size_t i = 0; i < w.size(); ++i) w[i] += share * correction[i];
  return w;
}

// A guess at the velocity, and what is left of the equation with it
struct Guess {
  Vector w, g;
};

// Takes the correction, or as large a share of it as makes the next one smaller
// (P. Deuflhard, Newton Methods for Nonlinear Problems, 2011, section 3.3)
Guess improved(const End& end, const std::vector<Vector>& A, const Vector& correction,
               const Vector& w) {
  Guess next;
  constexpr int k_most = 10;
  for (int halvings = 0; halvings < k_most; ++halvings) {
    next.w = moved(w, std::ldexp(Real(1), -halvings), correction);
    next.g = end.g(next.w);
    if (largest(solution(A, next.g)) < largest(correction)) break;
  }
  return next;
}

// Newton's method, until the corrections are rounding alone: as small as that of the
// velocities, or small and no longer shrinking, since force and place round as well
Vector velocity_at(const End& end) {
  constexpr int k_most = 60;
  const Real place = end.drift > 0 ? largest(end.x) / end.drift : 0;
  Guess now{end.v, end.g(end.v)};
  Real last = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < k_most; ++i) {
    const std::vector<Vector> A = end.slope(now.w, now.g);
    const Vector correction = solution(A, now.g);

    const Real size = largest(correction);
    if (!std::isfinite(size)) break;
    const Real scale = std::max({largest(end.v), largest(now.w), size});
    const Real smallest = 2 * k_u * scale + std::numeric_limits<Real>::min();
    const Real small = std::sqrt(k_u) * scale + 64 * k_u * place;
    if (size <= smallest || (size > last / 2 && size <= small))
      return moved(now.w, 1, correction);
    now = improved(end, A, correction, now.w);
    last = size;
  }
  return Vector(end.v.size(), std::numeric_limits<Real>::quiet_NaN());
}

}  // namespace

void implicit_kick(State& state, const Acceleration& acceleration, Real t, Real dt) {
  state.v = velocity_at({state.x, state.v, acceleration, t, dt, 0});
}

void implicit_euler(State& state, const Acceleration& acceleration, Real t, Real dt) {
  // (2.17) The velocity at the end, then the place that it leads to
  const End end{state.x, state.v, acceleration, t + dt, dt, dt};
  state.v = velocity_at(end);
  state.x = end.place(state.v);
}

void implicit_midpoint(State& state, const Acceleration& acceleration, Real t,
                       Real dt) {
  // (2.18) To the middle by the rates there, and on by the same rates
  implicit_euler(state, acceleration, t, dt / 2);
  explicit_euler(state, acceleration, t + dt / 2, dt / 2);
}

void implicit_trapezoid(State& state, const Acceleration& acceleration, Real t,
                        Real dt) {
  // (2.19) By the rates at the start, and on by the rates at the end
  explicit_euler(state, acceleration, t, dt / 2);
  implicit_euler(state, acceleration, t + dt / 2, dt / 2);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
