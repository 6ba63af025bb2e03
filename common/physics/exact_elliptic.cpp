#include "common/physics/exact_elliptic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace timestep::exact {
namespace {

constexpr double k_pi = std::numbers::pi;

// 1 - n sin² of an amplitude, without cancellation
double less_sine(const Jacobi& at, double n1) {
  return at.cn * at.cn + n1 * at.sn * at.sn;
}

}  // namespace

// By duplication; the series reaches round-off once the arguments are within a
// thousandth of each other. NaN of NaN.
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

double carlson_rc(double x, double y) {
  const double root = std::sqrt(std::abs(y - x));
  if (root == 0) return 1 / std::sqrt(x);
  const double angle =
      y > x ? std::atan2(root, std::sqrt(x)) : std::asinh(root / std::sqrt(y));
  return angle / root;
}

// As R_F, by duplication; each round leaves a term R_C behind
double carlson_rj(double x, double y, double z, double p) {
  double left_behind = 0;
  double scale = 1;
  while (true) {
    const double mean = (x + y + z + 2 * p) / 5;
    const double X = 1 - x / mean;
    const double Y = 1 - y / mean;
    const double Z = 1 - z / mean;
    const double P = -(X + Y + Z) / 2;
    const double most = std::max({std::abs(X), std::abs(Y), std::abs(Z)});
    if (!(most >= 1e-3) || std::isinf(mean)) {
      const double e2 = X * Y + Y * Z + Z * X - 3 * P * P;
      const double e3 = X * Y * Z + 2 * e2 * P + 4 * P * P * P;
      const double e4 = (2 * X * Y * Z + e2 * P + 3 * P * P * P) * P;
      const double e5 = X * Y * Z * P * P;
      const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22
                            - 9 * e2 * e3 / 52 + 3 * e5 / 26;
      return 3 * left_behind + scale * series / (mean * std::sqrt(mean));
    }
    const double rx = std::sqrt(x);
    const double ry = std::sqrt(y);
    const double rz = std::sqrt(z);
    const double lambda = rx * ry + ry * rz + rz * rx;
    const double alpha = p * (rx + ry + rz) + rx * ry * rz;
    left_behind += scale * carlson_rc(alpha * alpha, p * (p + lambda) * (p + lambda));
    scale /= 4;
    x = (x + lambda) / 4;
    y = (y + lambda) / 4;
    z = (z + lambda) / 4;
    p = (p + lambda) / 4;
  }
}

double Elliptic::quarter() const {
  return m1 == 0 ? std::numeric_limits<double>::infinity() : carlson_rf(0, m1, 1);
}

double Elliptic::first_kind(double phi) const {
  const double half_turns = std::round(phi / k_pi);
  const double rest = phi - k_pi * half_turns;
  const double s = std::sin(rest);
  const double c = std::cos(rest);
  const double part = s * carlson_rf(c * c, c * c + m1 * s * s, 1);
  return half_turns == 0 ? part : part + 2 * half_turns * quarter();
}

// By descending Landen steps (arithmetic-geometric mean)
double Elliptic::am(double w) const {
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
    phi = (phi + std::atan2(c[n] * s, std::hypot(a[n] * std::cos(phi), b[n] * s))) / 2;
  }
  return phi + 2 * k_pi * turns;
}

Jacobi Elliptic::jacobi(double w) const {
  if (m1 == 0) {
    const double held = std::clamp(w, -350.0, 350.0);
    return {std::tanh(held), 1 / std::cosh(held), 1 / std::cosh(held)};
  }

  // Half turns apart, which change signs alone
  const double K = quarter();
  const double half_turns = std::round(w / (2 * K));
  const double rest = half_turns == 0 ? w : w - 2 * K * half_turns;
  const double sign = std::remainder(half_turns, 2) == 0 ? 1 : -1;
  const bool far = std::abs(rest) > K / 2;

  // Beyond K/2, where cn and dn are small, by those of K - w
  const double phi = am(far ? K - std::abs(rest) : rest);
  const double s = std::sin(phi);
  const double c = std::cos(phi);
  const double d = std::sqrt(c * c + m1 * s * s);
  if (!far) return {sign * s, sign * c, d};
  const double k1 = std::sqrt(m1);
  return {sign * std::copysign(c / d, rest), sign * k1 * s / d, k1 / d};
}

double Elliptic::sine_part(double n1, double w) const {
  const double K = quarter();
  const double half_turns = std::round(w / (2 * K));
  const double rest = half_turns == 0 ? w : w - 2 * K * half_turns;
  const Jacobi at = jacobi(rest);
  const auto& [sn, cn, dn] = at;
  const double part =
      sn * sn * sn / 3 * carlson_rj(cn * cn, dn * dn, 1, less_sine(at, n1));
  if (half_turns == 0) return part;
  return part + 2 * half_turns * carlson_rj(0, m1, 1, n1) / 3;
}

double Elliptic::cosine_part(double n1, double w) const {
  // The third kind at N, where (1 - n) (1 - N) = m1 (NIST 19.7.9)
  const double N1 = m1 / n1;
  const Jacobi at = jacobi(w);
  const auto& [sn, cn, dn] = at;
  const double rest =
      sn * cn * carlson_rc(dn * dn, less_sine(at, n1) * less_sine(at, N1));
  return m1 == 0 ? rest : N1 * sine_part(N1, w) + rest;
}

Jacobi sum(const Jacobi& a, const Jacobi& b, double m) {
  const double d = a.cn * a.cn + a.sn * a.sn * b.dn * b.dn;
  return {(a.sn * b.cn * b.dn + b.sn * a.cn * a.dn) / d,
          (a.cn * b.cn - a.sn * b.sn * a.dn * b.dn) / d,
          (a.dn * b.dn - m * a.sn * a.cn * b.sn * b.cn) / d};
}

}  // namespace timestep::exact
