#include "common/physics/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace timestep::exact {
namespace {

// phi_1(z) = (1 - e^-z) / z and phi_2(z) = (1 - phi_1(z)) / z, without cancellation.
struct Phi {
  double one, two;
};

Phi phi(double z) {
  if (z > 0.5) {
    const double one = -std::expm1(-z) / z;
    return {one, (1 - one) / z};
  }

  // Taylor: phi_2 = sum of (-z)^k / (k+2)!; below z = 1/2 sixteen terms reach round-off
  double term = 0.5;
  double two = 0;
  for (int k = 0; k < 16; ++k) {
    two += term;
    term *= -z / (k + 3);
  }
  return {1 - z * two, two};
}

// Straight fall with quadratic drag: speed w downwards and distance fallen after t,
// from speed w >= 0 at the start. vt: terminal speed.
Coordinate fall(double w, double vt, double g, double t) {
  const double q = g * t / vt;
  const double r = w / vt;
  const double log =
      q < 1 ? std::log1p(2 * std::pow(std::sinh(q / 2), 2) + r * std::sinh(q))
            : q + std::log((1 + r + (1 - r) * std::exp(-2 * q)) / 2);
  const double tanh = std::tanh(q);
  return {vt * vt / g * log, vt * (r + tanh) / (1 + r * tanh)};
}

// Straight rise with quadratic drag from speed v > 0, until it stops and falls back.
Coordinate rise_and_fall(double v, double vt, double g, double t) {
  const double r = v / vt;
  const double t_top = vt / g * std::atan(r);
  const double q = g * std::min(t, t_top) / vt;
  const double height =
      vt * vt / g * std::log1p(-2 * std::pow(std::sin(q / 2), 2) + r * std::sin(q));
  if (t <= t_top) return {height, vt * std::tan(std::atan(r) - q)};

  const Coordinate down = fall(0, vt, g, t - t_top);
  return {height - down.x, -down.v};
}

// The path in the vertical plane, over d = s0 - s with s = asinh(slope): 0 at the start
// and growing as the path bends down.
struct Hodograph {
  double u0, s0, g, k_over_m;

  // Horizontal speed: Bernoulli's closed form. F(s0) - F(s) with F = sinh s cosh s + s
  // is written as a product, so that nothing cancels near the start.
  double u(double d) const {
    const double fall = std::cosh(2 * s0 - d) * std::sinh(d) + d;
    return 1 / std::sqrt(1 / (u0 * u0) + k_over_m / g * fall);
  }

  double dt_dd(double d) const { return u(d) * std::cosh(s0 - d) / g; }

  // How far Gauss quadrature may reach from d: u has a pole at a distance of about
  // g / (2 k/m v²) before d, and 10 nodes reach round-off over half of that.
  double panel(double d) const {
    const double v = u(d) * std::cosh(s0 - d);
    return std::min(0.125, g / (4 * k_over_m * v * v));
  }

  // Time, distance and height gained between two places: 10-point Gauss-Legendre
  glm::dvec3 between(double d_from, double d_to) const {
    static constexpr std::array<std::array<double, 2>, 5> nodes{{
        {0.1488743389816312, 0.2955242247147529},
        {0.4333953941292472, 0.2692667193099963},
        {0.6794095682990244, 0.2190863625159820},
        {0.8650633666889845, 0.1494513491505806},
        {0.9739065285171717, 0.0666713443086881},
    }};
    const double middle = (d_from + d_to) / 2;
    const double half = (d_to - d_from) / 2;
    glm::dvec3 sum{0};
    for (const auto& [node, weight] : nodes) {
      for (const double d : {middle - half * node, middle + half * node}) {
        const glm::dvec3 rate{1, u(d), u(d) * std::sinh(s0 - d)};
        sum += weight * half * dt_dd(d) * rate;
      }
    }
    return sum;
  }
};

// Distance and height (x, y) and velocity in the plane after t.
struct PlaneMotion {
  glm::dvec2 x, v;
};

PlaneMotion fly(const Hodograph& path, double t) {
  constexpr double k_straight = -36;  // slope -2e15: straight down, to round-off
  double d = 0;
  glm::dvec3 sum{0};

  // Whole panels while the time is not used up
  while (path.s0 - d > k_straight) {
    const double next = d + path.panel(d);
    const glm::dvec3 panel = path.between(d, next);
    if (sum.x + panel.x > t) break;
    sum += panel;
    d = next;
  }
  const double left = t - sum.x;
  if (path.s0 - d <= k_straight) {
    const double vt = std::sqrt(path.g / path.k_over_m);
    const Coordinate down = fall(-path.u(d) * std::sinh(path.s0 - d), vt, path.g, left);
    return {{sum.y, sum.z - down.x}, {path.u(d), -down.v}};
  }

  // The part of the last panel: Newton on its time, which is smooth and grows with d
  double end = d;
  for (int i = 0; i < 8; ++i) {
    const double time = end > d ? path.between(d, end).x : 0;
    end += (left - time) / path.dt_dd(end);
  }
  sum += path.between(d, end);
  const double u = path.u(end);
  return {{sum.y, sum.z}, {u, u * std::sinh(path.s0 - end)}};
}

}  // namespace

Motion constant_acceleration(const Motion& start, const glm::dvec3& a, double t) {
  return {start.x + t * (start.v + t / 2 * a), start.v + t * a};
}

Motion linear_drag(const Motion& start, const glm::dvec3& g, double b, double t) {
  const auto [one, two] = phi(b * t);
  return {start.x + t * (one * start.v + t * two * g),
          std::exp(-b * t) * start.v + t * one * g};
}

Motion quadratic_drag(const Motion& start, const glm::dvec3& g, double k_over_m,
                      double t) {
  const double strength = glm::length(g);
  if (k_over_m == 0 || strength == 0) return constant_acceleration(start, g, t);

  // Split the velocity into up and along the ground
  const glm::dvec3 up = -g / strength;
  const double v_up = glm::dot(start.v, up);
  const glm::dvec3 flat = start.v - v_up * up;
  const double u0 = glm::length(flat);

  // Straight up or down, all in closed form
  if (u0 <= 1e-100 * std::abs(v_up) || u0 == 0) {
    const double vt = std::sqrt(strength / k_over_m);
    const Coordinate down = fall(std::max(-v_up, 0.0), vt, strength, t);
    const Coordinate line =
        v_up > 0 ? rise_and_fall(v_up, vt, strength, t) : Coordinate{-down.x, -down.v};
    return {start.x + line.x * up, line.v * up};
  }

  const Hodograph path{u0, std::asinh(v_up / u0), strength, k_over_m};
  const auto [x, v] = fly(path, t);
  const glm::dvec3 along = flat / u0;
  return {start.x + x.x * along + x.y * up, v.x * along + v.y * up};
}

Coordinate oscillator(const Coordinate& start, double omega, double gamma, double t) {
  const double delta = omega * omega - gamma * gamma;
  double c = std::exp(-gamma * t);  // e^(-gamma t) cos(nu t)
  double s = c * t;                 // e^(-gamma t) sin(nu t) / nu, nu = sqrt(delta)
  if (delta > 0) {
    const double nu = std::sqrt(delta);
    s = c * std::sin(nu * t) / nu;
    c *= std::cos(nu * t);
  } else if (delta < 0) {
    // Overdamped: close to critical by sinh; else the slow rate as omega² / (fast
    // rate), so that nothing cancels
    const double beta = std::sqrt(-delta);
    if (beta * t < 1) {
      s = c * std::sinh(beta * t) / beta;
      c *= std::cosh(beta * t);
    } else {
      const double slow = std::exp(-omega * omega / (gamma + beta) * t);
      const double fast = std::exp(-(gamma + beta) * t);
      c = (slow + fast) / 2;
      s = (slow - fast) / (2 * beta);
    }
  }
  return {start.x * c + (start.v + gamma * start.x) * s,
          start.v * c - (omega * omega * start.x + gamma * start.v) * s};
}

}  // namespace timestep::exact
