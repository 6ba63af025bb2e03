#include "common/physics/side_of_plane.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// A number to twice the digits: what double has of it, and what rounding left over
struct Twice {
  double high, low;
};

Twice exact_sum(double a, double b) {
  const double high = a + b;
  const double part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

Twice exact_product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

// A sum without rounding: ascending terms that do not overlap, so that the last one has
// its sign. 6 products of 3 factors of 2 parts each make 192 at most.
struct ExactSum {
  std::array<double, 193> terms;
  std::size_t size = 0;
};

void add(ExactSum& sum, double x) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sum.size; ++i) {
    const Twice both = exact_sum(x, sum.terms[i]);
    if (both.low != 0) sum.terms[kept++] = both.low;
    x = both.high;
  }
  if (x != 0) sum.terms[kept++] = x;
  sum.size = kept;
}

void add_product(ExactSum& sum, const Twice& a, const Twice& b, const Twice& c) {
  for (const double x : {a.high, a.low}) {
    for (const double y : {b.high, b.low}) {
      if (x == 0 || y == 0) continue;
      const Twice xy = exact_product(x, y);
      for (const double z : {c.high, c.low}) {
        const Twice low = exact_product(xy.low, z), high = exact_product(xy.high, z);
        for (const double term : {low.low, low.high, high.low, high.high})
          if (term != 0) add(sum, term);
      }
    }
  }
}

using ExactVec3 = std::array<Twice, 3>;

ExactVec3 exact_difference(const glm::dvec3& a, const glm::dvec3& b) {
  return {exact_sum(a.x, -b.x), exact_sum(a.y, -b.y), exact_sum(a.z, -b.z)};
}

Twice minus(const Twice& x) {
  return {-x.high, -x.low};
}

int sign(double x) {
  return int(x > 0) - int(x < 0);
}

int exact_side(const ExactVec3& u, const ExactVec3& v, const ExactVec3& w) {
  ExactSum determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    add_product(determinant, u[i], v[j], w[k]);
    add_product(determinant, minus(u[i]), v[k], w[j]);
  }
  return determinant.size == 0 ? 0 : sign(determinant.terms[determinant.size - 1]);
}

// a d - b c; the two products may all but cancel
double minor(const Twice& a, const Twice& b, const Twice& c, const Twice& d) {
  const Twice ad = exact_product(a.high, d.high), bc = exact_product(b.high, c.high);
  const double rest = (a.high * d.low - b.high * c.low)
                      + (a.low * d.high - b.low * c.high) + (ad.low - bc.low);
  const Twice sum = exact_sum(ad.high, -bc.high);
  return sum.high + (sum.low + rest);
}

}  // namespace

int side_of_plane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                  const glm::dvec3& p) {
  // (4.22) in double, and the same with all signs positive: what can be lost of it
  const glm::dvec3 u = b - a, v = c - a, w = p - a;
  double determinant = 0, positive = 0;
  for (glm::length_t i = 0; i < 3; ++i) {
    const glm::length_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double vw = v[j] * w[k], wv = v[k] * w[j];
    determinant += u[i] * (vw - wv);
    positive += std::abs(u[i]) * (std::abs(vw) + std::abs(wv));
  }

  // Each term rounds 8 times by 2^-53 at most
  if (std::abs(determinant) > 8 * 0x1p-53 * positive) return sign(determinant);
  return exact_side(exact_difference(b, a), exact_difference(c, a),
                    exact_difference(p, a));
}

glm::dvec3 accurate_normal(const glm::dvec3& a, const glm::dvec3& b,
                           const glm::dvec3& c) {
  const auto [ux, uy, uz] = exact_difference(b, a);
  const auto [vx, vy, vz] = exact_difference(c, a);
  return {minor(uy, uz, vy, vz), minor(uz, ux, vz, vx), minor(ux, uy, vx, vy)};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
