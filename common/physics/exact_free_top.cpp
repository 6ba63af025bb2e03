#include "common/physics/exact_free_top.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {
namespace {

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
                                   : std::numeric_limits<double>::infinity()};
}

double flip_interval(const glm::dvec3& inertia, const glm::dvec3& omega) {
  return free_top_motion(inertia, omega).period / 2;
}

}  // namespace timestep::exact
