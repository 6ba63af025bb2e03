#include "common/physics/exact_top.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {
namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_never = std::numeric_limits<double>::infinity();

// A number to twice the digits, as the sum of two
struct Twice {
  double high, low;
};

Twice difference(double a, double b) {
  const double high = a - b;
  const double part = high - a;
  return {high, (a - (high - part)) - (b + part)};
}

Twice product(const Twice& a, double b) {
  const double high = a.high * b;
  return {high, std::fma(a.high, b, -high) + a.low * b};
}

// (L² - 2 E I2) of moments a <= b <= c: which axis omega goes round. All digits of it,
// as the separatrix is where it vanishes.
double beyond_separatrix(const glm::dvec3& I, const glm::dvec3& omega) {
  const auto part = [](const Twice& moments, double moment, double rate) {
    return product(product(product(moments, moment), rate), rate);
  };
  const Twice least = part(difference(I.y, I.x), I.x, omega.x);
  const Twice most = part(difference(I.z, I.y), I.z, omega.z);
  return (most.high - least.high) + (most.low - least.low);
}

double power_of_two_below(const glm::dvec3& v) {
  return std::exp2(
      std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), 0x1p-1000})));
}

// Less than 1e-60 of a unit is nothing
glm::dvec3 in_units(double unit, const glm::dvec3& omega) {
  glm::dvec3 v = omega / unit;
  for (glm::length_t i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 1e-60) v[i] = 0;
  return v;
}

// The body's axes in another, right-handed order
struct Order {
  std::array<glm::length_t, 3> axis;

  double hand() const { return (axis[1] - axis[0] + 3) % 3 == 1 ? 1 : -1; }

  glm::dvec3 of(const glm::dvec3& v) const {
    return {v[axis[0]], hand() * v[axis[1]], v[axis[2]]};
  }

  glm::dvec3 back(const glm::dvec3& v) const {
    glm::dvec3 body{};
    body[axis[0]] = v.x;
    body[axis[1]] = hand() * v.y;
    body[axis[2]] = v.z;
    return body;
  }
};

// (3.30) A free top's motion about its axes in the order in which omega goes round the
// third, and the second is the middle one: omega = amplitude (cn, sn, dn) of lambda t.
struct Circulation {
  Order order;
  glm::dvec3 I, omega;  // omega: at the start
  glm::dvec3 amplitude;
  double lambda;
  Elliptic elliptic;

  Circulation(const glm::dvec3& inertia, const glm::dvec3& start);
};

Circulation::Circulation(const glm::dvec3& inertia, const glm::dvec3& start)
    : order{{0, 1, 2}} {
  std::ranges::sort(order.axis, {}, [&](glm::length_t i) { return inertia[i]; });
  const auto moments = [&] {
    return glm::dvec3{inertia[order.axis[0]], inertia[order.axis[1]],
                      inertia[order.axis[2]]};
  };
  const double beyond = beyond_separatrix(moments(), order.of(start));
  if (beyond < 0) std::swap(order.axis[0], order.axis[2]);
  I = moments();
  omega = order.of(start);

  // Squares of the amplitudes, as sums; without a difference of moments nothing moves
  const double second = omega.y * omega.y * I.y / (I.z - I.x);
  const bool sphere = I.z == I.x;
  const double A = omega.x * omega.x + (sphere ? 0 : second * (I.z - I.y) / I.x);
  const double C = omega.z * omega.z + (sphere ? 0 : second * (I.y - I.x) / I.z);
  const double B = I.x * (I.z - I.x) / (I.y * (I.z - I.y)) * A;
  amplitude = {std::sqrt(A), std::copysign(std::sqrt(B), (I.z - I.x) * omega.z),
               std::copysign(std::sqrt(C), omega.z)};
  lambda = std::sqrt((I.z - I.x) / I.x * (I.z - I.y) / I.y * C);

  // 1 - m by the one difference that vanishes on the separatrix
  const double size = I.z * (I.z - I.y) * C;
  elliptic = size == 0 ? Elliptic{0, 1}
                       : Elliptic{I.x * (I.y - I.x) * A / size, beyond / size};
}

// Euler's equations without torque: what turns about a principal axis goes on so
bool is_steady(const glm::dvec3& I, const glm::dvec3& omega) {
  return (I.y - I.x) * omega.x * omega.y == 0 && (I.z - I.y) * omega.y * omega.z == 0
         && (I.x - I.z) * omega.z * omega.x == 0;
}

glm::dquat about_z(double angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

// The rotation of the body's frame that makes L point along z, and the line of nodes
// e3 x L along x
glm::dquat nodes_from_body(const glm::dvec3& L) {
  const double nodes = std::atan2(L.x, -L.y);
  const double tilt = std::atan2(std::hypot(L.x, L.y), L.z);
  return glm::dquat(std::cos(tilt / 2), -std::sin(tilt / 2), 0, 0) * about_z(-nodes);
}

// (3.31) The angle by which the line of nodes has turned about L: that of a start at
// cn = 1, whose rate is between L / I1 and L / I2, and what the own start, at the
// functions `from`, makes of it: an angle on the sphere.
double nodes_turned(const Circulation& top, const Jacobi& from, const Jacobi& way,
                    const Jacobi& now, double t) {
  const glm::dvec3& I = top.I;
  const Elliptic& elliptic = top.elliptic;
  const double L = glm::length(I * top.omega);
  const double w = top.lambda * t;
  const double minus_n = I.z / I.x * ((I.y - I.x) / (I.z - I.y));
  const double n1 = I.y / I.x * ((I.z - I.x) / (I.z - I.y));

  const double root = std::sqrt(minus_n * n1 * (elliptic.m + minus_n));
  const double own =
      std::atan2(root * from.sn * way.sn * now.sn,
                 1 + minus_n * (now.sn * now.sn - from.sn * way.sn * now.cn * now.dn));

  // From the slower of the two rates on, so that nothing cancels
  const double faster = std::abs(I.y - I.x) / (I.x * I.y) / top.lambda;
  return I.x < I.y ? L * (t / I.y + faster * elliptic.cosine_part(n1, w)) - own
                   : L * (t / I.x + faster * n1 * elliptic.sine_part(n1, w)) + own;
}

}  // namespace

Turning free_top(const glm::dvec3& inertia, const Turning& start, double t) {
  // Units in which no square leaves the range
  const double unit = power_of_two_below(start.omega);
  const glm::dvec3 I = inertia / power_of_two_below(inertia);
  const glm::dvec3 omega = in_units(unit, start.omega);
  const double s = t * unit;
  if (is_steady(I, omega)) {
    const double rate = glm::length(omega);
    const glm::dvec3 axis = rate > 0 ? omega / rate : omega;
    return {start.q * glm::dquat(std::cos(rate * s / 2), std::sin(rate * s / 2) * axis),
            start.omega};
  }

  // (3.30) omega
  const Circulation top(I, omega);
  const glm::dvec3 ratio = top.omega / top.amplitude;
  const Jacobi from{ratio.y, ratio.x, ratio.z};
  const Jacobi way = top.elliptic.jacobi(top.lambda * s);
  const Jacobi now = sum(from, way, top.elliptic.m);
  const glm::dvec3 turned = top.amplitude * glm::dvec3(now.cn, now.sn, now.dn);

  // (3.31) The attitude: into the nodes' frame, with it about L, and out of it
  const double angle = nodes_turned(top, from, way, now, s);
  const glm::dquat change = glm::conjugate(nodes_from_body(top.I * top.omega))
                            * about_z(angle) * nodes_from_body(top.I * turned);
  const glm::dvec3 part = top.order.back({change.x, change.y, change.z});
  return {start.q * glm::dquat(change.w, part), unit * top.order.back(turned)};
}

FreeTopMotion free_top_motion(const glm::dvec3& inertia, const glm::dvec3& omega) {
  const double unit = power_of_two_below(omega);
  const Circulation top(inertia / power_of_two_below(inertia), in_units(unit, omega));
  return {.circulating_axis = static_cast<int>(top.order.axis[2]),
          .m = top.elliptic.m,
          .period = top.lambda > 0 ? 4 * top.elliptic.quarter() / (unit * top.lambda)
                                   : k_never};
}

double flip_interval(const glm::dvec3& inertia, const glm::dvec3& omega) {
  return free_top_motion(inertia, omega).period / 2;
}

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
  if (n1 == 0) return 2 * k_pi * std::round(w / (2 * top.elliptic.quarter()));
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
          .period = n.lambda > 0 ? 2 * n.elliptic.quarter() / n.lambda : k_never};
}

}  // namespace timestep::exact
