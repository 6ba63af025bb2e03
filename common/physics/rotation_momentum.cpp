#include "common/physics/rotation_momentum.hpp"

#include <limits>
#include <string>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;  // unit round-off

Mat3 skew(const Vec3& a) {  // skew(a) b = a x b
  return Mat3(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
}

// Newton's method from a start that is right for small steps, until the corrections are
// rounding alone: no larger than it, or small and no longer shrinking. NaN is neither.
template <typename Correction>
Vec3 root(Vec3 w, const Correction& correction, const char* method) {
  Real before = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < 30; ++i) {
    const Vec3 change = correction(w);
    w += change;
    const Real size = glm::length(change);
    const Real all = glm::length(w);
    if (size <= k_u * all || (size >= before / 2 && size <= std::sqrt(k_u) * all))
      return w;
    before = size;
  }
  throw Unsolved(std::string(method) + " has no solution at this time step");
}

}  // namespace

Vec3 velocity_half_way(const Vec3& omega, const Vec3& I, Real dt) {
  const Vec3 L = I * omega;
  const auto correction = [&](const Vec3& w) {
    // How the turned L changes with w; exact but for terms of second order in dt w
    const Vec3 turned = in_body(rotation_by(dt / 2 * w), L);
    const Mat3 slope = skew(turned) * (Mat3(1) - dt / 4 * skew(w)) * (dt / 2);
    const Mat3 by_inertia(Vec3(1) / I * slope[0], Vec3(1) / I * slope[1],
                          Vec3(1) / I * slope[2]);
    return glm::inverse(Mat3(1) - by_inertia) * (turned / I - w);
  };
  return root(omega, correction, "lie_midpoint");
}

Quat moser_veselov_turn(const Vec3& omega, const Vec3& I, Real dt) {
  const Vec3 c = shape_ratios(I);
  const auto scalar = [](const Vec3& b) { return std::sqrt(1 - glm::dot(b, b)); };
  const auto correction = [&](const Vec3& b) {
    const Real a = scalar(b);
    const Vec3 f = dt / 2 * omega - a * b - gyroscopic_term(c, b);
    const Mat3 slope =
        a * Mat3(1) - glm::outerProduct(b, b / a) + gyroscopic_slope(c, b);
    return glm::inverse(slope) * f;
  };
  const Vec3 b = root(dt / 2 * omega, correction, "discrete_moser_veselov");
  return Quat(scalar(b), b);
}

}  // namespace timestep::inline TIMESTEP_PRECISION
