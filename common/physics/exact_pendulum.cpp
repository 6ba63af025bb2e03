#include "common/physics/exact_pendulum.hpp"

#include <cmath>
#include <numbers>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {
namespace {

constexpr double k_pi = std::numbers::pi;

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
    const Jacobi way = Elliptic{k2, rest}.jacobi(omega0 * t);
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
      sum({sign * s, c, std::abs(rate) / k}, elliptic.jacobi(w), elliptic.m);
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
