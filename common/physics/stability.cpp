#include "common/physics/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off

// Where a scheme stands on x'' = -x after some steps of length z
State after(const Scheme& scheme, Real x, Real v, Real z, int steps) {
  const Acceleration spring_of_one = [](auto place, auto, Real, auto a) {
    a[0] = -place[0];
  };
  Integration run = begin(scheme, spring_of_one, {{x}, {v}, {0}}, z);
  for (int i = 0; i < steps; ++i) advance(run);
  return read(run);
}

StepMatrix after(const Scheme& scheme, Real z, int steps) {
  const State from_x = after(scheme, 1, 0, z, steps);
  const State from_v = after(scheme, 0, 1, z, steps);
  return {from_x.x[0], from_v.x[0], from_x.v[0], from_v.v[0]};
}

double determinant(const StepMatrix& m) {
  return m.xx * m.vv - m.xv * m.vx;
}

// Such a scheme is judged by its trace: rounding alone would decide about a radius of 1
bool keeps_areas(const Scheme& scheme) {
  return std::ranges::all_of(std::array{Real(0.25), Real(0.5)}, [&](Real z) {
    return std::abs(determinant(step_matrix(scheme, z)) - 1) < 16 * k_u;
  });
}

}  // namespace

StepMatrix step_matrix(const Scheme& scheme, Real z) {
  const StepMatrix m = after(scheme, z, 1);
  if (!scheme.read) return m;

  // What a scheme reads at the start need not be what it was given: M = M1 / M0
  const StepMatrix s = after(scheme, z, 0);
  const double d = determinant(s);
  return {(m.xx * s.vv - m.xv * s.vx) / d, (m.xv * s.xx - m.xx * s.xv) / d,
          (m.vx * s.vv - m.vv * s.vx) / d, (m.vv * s.xx - m.vx * s.xv) / d};
}

double spectral_radius(const StepMatrix& m) {
  const double half_trace = (m.xx + m.vv) / 2;
  const double apart = (m.xx - m.vv) / 2;
  const double discriminant = apart * apart + m.xv * m.vx;

  // Eigenvalues closer than rounding can tell are one: a root would make much of it
  const double rounding =
      4 * k_u
      * (std::abs(apart) * (std::abs(m.xx) + std::abs(m.vv)) + std::abs(m.xv * m.vx));
  if (std::abs(discriminant) <= rounding) return std::abs(half_trace);
  const std::complex<double> root = std::sqrt(std::complex<double>(discriminant));
  return std::max(std::abs(half_trace + root), std::abs(half_trace - root));
}

double stability_limit(const Scheme& scheme) {
  const bool area = keeps_areas(scheme);
  const auto growth = [&](double z) {
    const StepMatrix m = step_matrix(scheme, Real(z));
    return area ? std::abs(m.xx + m.vv) - 2 : spectral_radius(m) - 1;
  };
  constexpr double k_rounding = 16 * k_u;
  constexpr double k_step = 1.0 / 32;
  constexpr double k_far = 100;

  // What grows at every z grows at 1/4 by far more than rounding could
  double below = 0.25;
  if (growth(below) > k_rounding) return 0;

  // Walk up to the first z that grows, then close in on the limit
  while (below < k_far && growth(below + k_step) <= k_rounding) below += k_step;
  if (below >= k_far) return std::numeric_limits<double>::infinity();
  double above = below + k_step;
  for (int i = 0; i < 60; ++i) {
    const double middle = (below + above) / 2;
    (growth(middle) <= 0 ? below : above) = middle;
  }
  return below;
}

ModifiedEnergy modified_energy(const StepMatrix& m, double z) {
  return {-m.vx / (2 * z), (m.xx - m.vv) / (2 * z), m.xv / (2 * z)};
}

EnergyRange energy_range(const ModifiedEnergy& h) {
  const double mean = h.xx + h.vv;
  const double spread = std::hypot(h.xx - h.vv, h.xv);

  // mean - spread without cancellation
  const double least = (4 * h.xx * h.vv - h.xv * h.xv) / (mean + spread);
  return {1 / (mean + spread), 1 / least};
}

double frequency_ratio(const StepMatrix& m, double z) {
  // (2.37) A step turns by the angle whose cosine is half the trace; its sine tells
  // more of a small one
  const double apart = (m.xx - m.vv) / 2;
  const double sine = std::sqrt(-m.xv * m.vx - apart * apart);
  return std::atan2(sine, (m.xx + m.vv) / 2) / z;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
