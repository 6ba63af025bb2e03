#include "common/physics/exact_pendulum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace timestep::exact {
namespace {

constexpr double k_pi = std::numbers::pi;

// Carlson's symmetric integral R_F by duplication; its series reaches round-off once
// the arguments are within a thousandth of each other. NaN of NaN.
double carlson_rf(double x, double y, double z) {
  while (true) {
    const double mean = (x + y + z) / 3;
    const double X = 1 - x / mean;
    const double Y = 1 - y / mean;
    const double Z = -X - Y;
    if (!(std::max({std::abs(X), std::abs(Y), std::abs(Z)}) >= 1e-3)) {
      const double e2 = X * Y - Z * Z;
      const double e3 = X * Y * Z;
      return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44)
             / std::sqrt(mean);
    }
    const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
  }
}

// Elliptic functions of the parameter m = 1 - m1
struct Elliptic {
  double m, m1;

  double quarter() const {
    return m1 == 0 ? std::numeric_limits<double>::infinity() : carlson_rf(0, m1, 1);
  }

  // first_kind(phi): the integral of the first kind for every phi
  double first_kind(double phi) const {
    const double half_turns = std::round(phi / k_pi);
    const double rest = phi - k_pi * half_turns;
    const double s = std::sin(rest);
    const double c = std::cos(rest);
    const double part = s * carlson_rf(c * c, c * c + m1 * s * s, 1);
    return half_turns == 0 ? part : part + 2 * half_turns * quarter();
  }

  // am(w), the inverse of F, by descending Landen steps (arithmetic-geometric mean)
  double am(double w) const {
    if (m1 == 0) return std::atan(std::sinh(w));
    const double turns = std::round(w / (4 * quarter()));
    std::array<double, 16> a{}, b{}, c{};
    a[0] = 1;
    b[0] = std::sqrt(m1);
    std::size_t n = 0;
    while (std::abs(a[n] - b[n]) > 1e-16 * a[n] && n + 1 < a.size()) {
      c[n + 1] = (a[n] - b[n]) / 2;
      a[n + 1] = (a[n] + b[n]) / 2;
      b[n + 1] = std::sqrt(a[n] * b[n]);
      ++n;
    }
    double phi = std::ldexp(a[n] * (w - 4 * quarter() * turns), static_cast<int>(n));

    // The angle whose sine is c/a sin phi; its cosine too, as a² = b² + c²
    for (; n > 0; --n) {
      const double s = std::sin(phi);
      phi =
          (phi + std::atan2(c[n] * s, std::hypot(a[n] * std::cos(phi), b[n] * s))) / 2;
    }
    return phi + 2 * k_pi * turns;
  }
};

// A pendulum's start, folded to within half a turn from hanging. k² = sin²(x / 2)
// + (v / (2 omega0))² is its energy in units of what it takes to reach the top; below 1
// it swings, above it turns.
struct Swing {
  double turns, half_angle, rate;  // rate: v / (2 omega0)
  double k2, rest;                 // rest = 1 - k2, without cancellation

  Swing(const Coordinate& start, double omega0)
      : turns(std::round(start.x / (2 * k_pi))),
        half_angle(start.x / 2 - k_pi * turns),
        rate(start.v / (2 * omega0)) {
    const double s = std::sin(half_angle);
    const double c = std::cos(half_angle);
    k2 = s * s + rate * rate;
    rest = (c - rate) * (c + rate);
  }
};

// Jacobi's functions of one argument: sn, cn of the amplitude, and dn² = 1 - m sn²
struct Jacobi {
  double sn, cn, dn;
};

Jacobi jacobi(const Elliptic& elliptic, double w) {
  // Half turns apart, which change signs alone
  const double K = elliptic.quarter();
  const double half_turns = std::round(w / (2 * K));
  const double rest = half_turns == 0 ? w : w - 2 * K * half_turns;
  const double sign = std::remainder(half_turns, 2) == 0 ? 1 : -1;
  const bool far = std::abs(rest) > K / 2;

  // Beyond K/2, where cn and dn are small, by those of K - w
  const double phi = elliptic.am(far ? K - std::abs(rest) : rest);
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  const double d = std::sqrt(c * c + elliptic.m1 * s * s);
  if (!far) return {sign * s, sign * c, d};
  const double k1 = std::sqrt(elliptic.m1);
  return {sign * std::copysign(c / d, rest), sign * k1 * s / d, k1 / d};
}

// Those of the sum of two arguments. A pendulum that starts close to the top keeps all
// digits of how close: an amplitude could not hold them.
Jacobi sum(const Jacobi& a, const Jacobi& b, double m) {
  const double d = a.cn * a.cn + a.sn * a.sn * b.dn * b.dn;
  return {(a.sn * b.cn * b.dn + b.sn * a.cn * a.dn) / d,
          (a.cn * b.cn - a.sn * b.sn * a.dn * b.dn) / d,
          (a.dn * b.dn - m * a.sn * a.cn * b.sn * b.cn) / d};
}

}  // namespace

Coordinate pendulum(const Coordinate& start, double omega0, double t) {
  const Swing swing(start, omega0);
  const auto& [turns, half_angle, rate, k2, rest] = swing;
  const double k = std::sqrt(k2);
  const double s = std::sin(half_angle);
  const double c = std::cos(half_angle);
  if (k2 == 0) return start;

  // (2.29) Swinging: sin(x / 2) = k sn, v = 2 k omega0 cn
  if (rest > 0) {
    const Jacobi way = jacobi({k2, rest}, omega0 * t);
    const Jacobi now = sum({s / k, rate / k, c}, way, k2);
    return {2 * (std::atan2(k * now.sn, now.dn) + k_pi * turns),
            2 * k * omega0 * now.cn};
  }

  // Turning over, or just reaching the top: x / 2 itself is the amplitude, which tells
  // the whole turns
  const Elliptic elliptic{1 / k2, -rest / k2};
  const double sign = std::copysign(1.0, rate);
  const double w = k * omega0 * t;
  const Jacobi now =
      sum({sign * s, c, std::abs(rate) / k}, jacobi(elliptic, w), elliptic.m);
  const double angle = std::atan2(now.sn, now.cn);
  const double rough = elliptic.am(elliptic.first_kind(sign * half_angle) + w);
  const double whole = 2 * k_pi * std::round((rough - angle) / (2 * k_pi));
  return {2 * (sign * (angle + whole) + k_pi * turns), sign * 2 * k * omega0 * now.dn};
}

double pendulum_period(const Coordinate& start, double omega0) {
  const Swing swing(start, omega0);
  if (swing.rest > 0) return 4 * Elliptic{swing.k2, swing.rest}.quarter() / omega0;
  const double k2 = swing.k2;
  return 2 * Elliptic{1 / k2, -swing.rest / k2}.quarter() / (std::sqrt(k2) * omega0);
}

TwoBodies spring_between(const TwoBodies& start, double m1, double m2, double k,
                         double length, double t) {
  const auto& [a, b] = start;
  const double m = m1 + m2;

  // (2.31) The centre of mass moves straight on, the distance is an oscillator
  const Coordinate centre{(m1 * a.x + m2 * b.x) / m, (m1 * a.v + m2 * b.v) / m};
  const double omega = std::sqrt(k * m / (m1 * m2));
  const Coordinate apart = oscillator({b.x - a.x - length, b.v - a.v}, omega, 0, t);
  const double x = centre.x + centre.v * t;
  const double distance = apart.x + length;
  return {{x - m2 / m * distance, centre.v - m2 / m * apart.v},
          {x + m1 / m * distance, centre.v + m1 / m * apart.v}};
}

}  // namespace timestep::exact
