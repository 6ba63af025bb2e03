// With P = I1 I2 I3 and the two sums
//   p = (|L|² - 2 E I1) (I3 - I2) / P,  q = (2 E I3 - |L|²) (I2 - I1) / P,
// lambda² is the larger of the two, and lambda² (1 - kappa²) is |p - q|, which is
// | |L|² - 2 E I2 | (I3 - I1) / P. Put lambda into the mean: the interval is
// pi / agm(lambda, lambda sqrt(1 - kappa²)). In the squares of omega nothing cancels
// but what makes the body choose between going round axis 1 and axis 3.
//
// A wobble that is ten times smaller puts off each flip by 2 ln(10) / sigma: it must
// grow ten times as much, and has as far to fall back.
#include "chapters/03-rigid-bodies/exercises/3_5_flips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace timestep {
namespace {

// From the axis of the smallest moment to that of the largest
std::array<int, 3> by_moment(const Vec3& I) {
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::sort(axes, {}, [&](int axis) { return I[axis]; });
  return axes;
}

// Arithmetic-geometric mean of a >= b > 0. The digits that are right double each time.
Real agm(Real a, Real b) {
  while (a - b > 1e-8 * a) {
    const Real mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return (a + b) / 2;
}

}  // namespace

int unstable_axis(const Vec3& I) {
  return by_moment(I)[1];
}

Real growth_rate(const Vec3& I, Real W) {
  const auto [i, j, k] = by_moment(I);
  return std::abs(W) * std::sqrt((I[j] - I[i]) * (I[k] - I[j]) / (I[i] * I[k]));
}

Real flip_interval(const Vec3& I, const Vec3& omega) {
  // Differences of the moments, and twice the energy about each axis
  const auto [i, j, k] = by_moment(I);
  const Real low = I[j] - I[i], high = I[k] - I[j], both = I[k] - I[i];
  const Vec3 e = I * omega * omega;

  // The sums p and q, and |p - q|
  const Real P = I.x * I.y * I.z;
  const Real p = (e[j] * low + e[k] * both) * high / P;
  const Real q = (e[j] * high + e[i] * both) * low / P;
  const Real apart = std::abs(e[k] * high - e[i] * low) * both / P;
  if (apart == 0) return std::numeric_limits<Real>::infinity();

  return std::numbers::pi / agm(std::sqrt(std::max(p, q)), std::sqrt(apart));
}

}  // namespace timestep
