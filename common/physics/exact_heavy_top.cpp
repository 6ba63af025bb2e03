#include "common/physics/exact_heavy_top.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {

double steady_discriminant(const HeavyTop& top, double theta, double omega3) {
  const double L3 = top.I3 * omega3;
  return L3 * L3 - 4 * top.I1 * top.mass * top.g * top.l * std::cos(theta);
}

std::optional<SteadyPrecession> steady_precession(const HeavyTop& top, double theta,
                                                  double omega3) {
  const double discriminant = steady_discriminant(top, theta, omega3);
  if (!(discriminant >= 0)) return std::nullopt;

  // (3.33) I1 W² cos theta - I3 omega3 W + m g l = 0, by the sum that does not cancel
  const double L3 = top.I3 * omega3;
  const double twice = L3 + std::copysign(std::sqrt(discriminant), L3);
  if (twice == 0) return std::nullopt;
  return SteadyPrecession{.slow = 2 * top.mass * top.g * top.l / twice,
                          .fast = twice / (2 * top.I1 * std::cos(theta))};
}

double least_steady_spin(const HeavyTop& top, double theta) {
  const double weight = top.mass * top.g * top.l * std::max(0.0, std::cos(theta));
  return 2 * std::sqrt(top.I1 * weight) / top.I3;
}

namespace {

// (3.34) u = cos theta goes between its start u0, where theta rests, and another root
// u1 of a cubic; u3 >= 1 is the third. What is small is not taken as a difference: the
// fractions of 1 - u0 and of 1 + u0 that are left at u1 are ratios of products.
struct Nodding {
  double a, above, below;  // I3 omega3 / I1, 1 - u0, 1 + u0
  double x, y;             // phi' is the mean of x (1-u0)/(1-u) and y (1+u0)/(1+u)
  bool falls;
  double reach;  // |u1 - u0| / (1 - u0²)
  double lambda;
  Elliptic elliptic;
  double n1_x, n1_y;  // (1-u)/(1-u0) = (cn² + n1_x sn²) / scale, same for y and 1+u

  Nodding(const HeavyTop& top, const HeavyTopStart& start);

  double scale(const Jacobi& at) const { return falls ? at.dn * at.dn : 1; }
  double share_x(const Jacobi& at) const {
    return (at.cn * at.cn + n1_x * at.sn * at.sn) / scale(at);
  }
  double share_y(const Jacobi& at) const {
    return (at.cn * at.cn + n1_y * at.sn * at.sn) / scale(at);
  }
  double theta(const Jacobi& at) const {
    return 2
           * std::atan2(std::sqrt(above * share_x(at)), std::sqrt(below * share_y(at)));
  }
};

// Of the cubic: beta (u3 - 1), beta (u3 - u1), and the fraction of 1 - u0 left at u1
struct Roots {
  double third, apart, rise;
};

// From the product of u3 - 1 and 1 - u1, and from their difference excess / beta
Roots roots(double beta, double above, double x, double excess) {
  const double apart = std::hypot(excess, 2 * std::sqrt(beta * above) * x);
  if (excess < 0) {
    const double left = (apart - excess) / 2;
    return {beta * above * x * x / left, apart, left / (beta * above)};
  }
  const double third = (apart + excess) / 2;
  return {third, apart, third > 0 ? x * x / third : 0};
}

Nodding::Nodding(const HeavyTop& top, const HeavyTopStart& start) {
  const double half = start.theta > 1e-150 ? start.theta / 2 : 0;
  const double rate = start.phi_rate;
  above = 2 * std::sin(half) * std::sin(half);
  below = 2 * std::cos(half) * std::cos(half);
  a = top.I3 / top.I1 * start.omega3;
  x = rate * below - a;
  y = rate * above + a;
  const double beta = 2 * top.mass * top.g * top.l / top.I1;
  const double pull = beta + 2 * rate * (rate * std::cos(start.theta) - a);

  const double excess = a * a + rate * rate * above * below - 2 * beta;
  const auto [third, apart, rise] = roots(beta, above, x, excess);

  // Falling from u0, the higher of the two, or rising from the lower
  falls = pull > 0;
  const double to_third = third + beta * above;
  reach = above > 0 && to_third > 0 ? std::abs(pull) / to_third : 0;
  const double between = beta * above * below * reach;
  const double whole = to_third + (falls ? between : 0);
  lambda = std::sqrt(whole) / 2;
  elliptic = {0, 1};
  n1_x = n1_y = 1;
  if (reach == 0) return;
  elliptic = {between / whole, (falls ? to_third : apart) / whole};
  n1_x = falls ? elliptic.m1 * (1 + below * reach) : rise;
  n1_y = falls ? elliptic.m1 * y * y / (2 * beta + third) : 1 + above * reach;
}

// The time integral of rate / share, where 1 / share is 1 + c sn² / (1 - n sn²)
double turned(const Nodding& top, double rate, double c, double n1, double t) {
  if (c == 0) return rate * t;

  // Right through the pole: half a turn of phi each time, at once
  const double w = top.lambda * t;
  if (n1 == 0)
    return 2 * std::numbers::pi * std::round(w / (2 * top.elliptic.quarter()));
  return rate * (t + c * top.elliptic.sine_part(n1, w) / top.lambda);
}

}  // namespace

HeavyTopAngles heavy_top(const HeavyTop& top, const HeavyTopStart& start, double t) {
  const Nodding n(top, start);
  const Jacobi at = n.elliptic.jacobi(n.lambda * t);
  const double sign = n.falls ? -n.elliptic.m1 : 1;
  const double X = turned(n, n.x, sign * n.below * n.reach, n.n1_x, t);
  const double Y = turned(n, n.y, -sign * n.above * n.reach, n.n1_y, t);

  // phi' = (b - a u) / (1 - u²); near a pole by its parts
  const double x = n.share_x(at);
  const double y = n.share_y(at);
  const auto over = [](double rate, double share) {
    return share > 0 ? rate / share : 0;
  };
  const double moved = n.a * sign * n.reach * at.sn * at.sn / n.scale(at);
  const double phi_rate = std::min(x, y) < 0.5 ? (over(n.x, x) + over(n.y, y)) / 2
                                               : (start.phi_rate - moved) / (x * y);

  // theta' = -u' / sin theta; at a pole cn / left is what it is right beyond
  const double left = std::sqrt(x * y) * n.scale(at);
  const double slope = n.falls ? 1 / at.dn : at.dn;
  const double size = 2 * sign * n.lambda * n.reach * std::sqrt(n.above * n.below);
  const double beyond = -1 / std::sqrt(n.falls ? n.n1_x : n.n1_y);
  const double cosine = left > 0 ? at.cn / left : beyond;
  return {.theta = n.theta(at),
          .phi = (X + Y) / 2,
          .psi = (start.omega3 - n.a) * t + (Y - X) / 2,
          .theta_rate = -size * at.sn * slope * cosine,
          .phi_rate = phi_rate,
          .sine = std::sqrt(n.above * n.below * x * y)};
}

Turning turning(const HeavyTopAngles& angles, double omega3) {
  const auto& [theta, phi, psi, theta_rate, phi_rate, sine] = angles;
  const double across = phi_rate * sine;
  const glm::dquat tilt(std::cos(theta / 2), std::sin(theta / 2), 0, 0);
  return {about_z(phi) * tilt * about_z(psi),
          {theta_rate * std::cos(psi) + across * std::sin(psi),
           across * std::cos(psi) - theta_rate * std::sin(psi), omega3}};
}

Nutation nutation(const HeavyTop& top, const HeavyTopStart& start) {
  const Nodding n(top, start);
  const double other = n.theta({1, 0, std::sqrt(n.elliptic.m1)});
  return {.theta_min = std::min(start.theta, other),
          .theta_max = std::max(start.theta, other),
          .period = n.lambda > 0 ? 2 * n.elliptic.quarter() / n.lambda
                                 : std::numeric_limits<double>::infinity()};
}

}  // namespace timestep::exact
