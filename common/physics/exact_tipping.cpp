#include "common/physics/exact_tipping.hpp"

#include <cmath>
#include <limits>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

// cos from - cos (from + by), half of it and without cancellation
double half_fall(double from, double by) {
  return std::sin(from + by / 2) * std::sin(by / 2);
}

}  // namespace

double tipping_time(double omega0, double from, double by) {
  constexpr double k_balanced = 1e-150;
  if (by == 0) return 0;
  if (from < k_balanced) return k_infinity;

  // A pendulum that hangs at pi and turns back at `from`. F(psi) = sin psi R_F(cos²
  // psi, 1 - m sin² psi, 1) with sin psi, cos psi = sqrt(fall), s0 c over c0 s and m =
  // c0²; R_F takes that factor into its arguments
  const double s0 = std::sin(from / 2);
  const double c0 = std::cos(from / 2);
  const double s = std::sin((from + by) / 2);
  const double c = std::cos((from + by) / 2);
  const double time = carlson_rf(s0 * s0 * c * c, s0 * s0 * c0 * c0, c0 * c0 * s * s);
  return std::sqrt(half_fall(from, by)) * time / omega0;
}

RodMotion rod_on_rough_floor(const FallingRod& rod, double theta) {
  const auto& [m, length, g, theta0] = rod;
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  const double fallen = 2 * half_fall(theta0, theta - theta0);
  const double s0 = std::sin(theta0 / 2);

  // Energy, then the accelerations of the centre
  const double normal = (1 - 3 * c) * (1 - 3 * c) + 12 * c * s0 * s0;
  return {.omega = std::sqrt(3 * g / length * fallen),
          .alpha = 3 * g / (2 * length) * s,
          .normal = m * g / 4 * normal,
          .friction = 3 * m * g / 4 * s * (c - 2 * fallen)};
}

RodMotion rod_on_smooth_floor(const FallingRod& rod, double theta) {
  const auto& [m, length, g, theta0] = rod;
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  const double fallen = 2 * half_fall(theta0, theta - theta0);
  const double s0 = std::sin(theta0 / 2);

  // Its moment of inertia about the end's place over that about the centre, in energy;
  // then the accelerations
  const double inertia = 1 + 3 * s * s;
  const double square = 12 * g / length * fallen / inertia;
  const double normal = 1 + 3 * (1 - c) * (1 - c) + 12 * c * s0 * s0;
  return {.omega = std::sqrt(square),
          .alpha = 3 * s * (2 * g / length - c * square) / inertia,
          .normal = m * g * normal / (inertia * inertia),
          .friction = 0};
}

double rod_time(const FallingRod& rod, double theta) {
  const double omega0 = std::sqrt(3 * rod.g / (2 * rod.length));
  return tipping_time(omega0, rod.theta0, theta - rod.theta0);
}

PainleveForces painleve(const PainleveRod& rod) {
  const double s = std::sin(rod.theta);
  const double c = std::cos(rod.theta);
  const double p = (1 + 3 * c * (c - rod.mu * s)) / rod.mass;
  const double b = rod.half_length * rod.omega * rod.omega * s - rod.g;
  if (b < 0 && p > 0) return {p, b, Painleve::slides, -b / p};
  if (b < 0) return {p, b, Painleve::inconsistent, k_infinity};
  if (p < 0) return {p, b, Painleve::indeterminate, k_infinity};
  return {p, b, Painleve::parts, 0};
}

double painleve_friction(double theta) {
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  return (1 + 3 * c * c) / (3 * s * c);
}

double block_angle(const RockingBlock& block) {
  return std::atan2(block.half_width, block.half_height);
}

double block_frequency(const RockingBlock& block) {
  return std::sqrt(3 * block.g / (4 * std::hypot(block.half_width, block.half_height)));
}

double rate_ratio(const RockingBlock& block) {
  const double s = std::sin(block_angle(block));
  return 1 - 1.5 * s * s;
}

double quarter_time(const RockingBlock& block, double theta0) {
  return tipping_time(block_frequency(block), block_angle(block) - theta0, theta0);
}

double impact_rate(const RockingBlock& block, double theta0) {
  const double fall = half_fall(block_angle(block) - theta0, theta0);
  return 2 * block_frequency(block) * std::sqrt(fall);
}

double slender_quarter_time(const RockingBlock& block, double theta0) {
  const double x = theta0 / (block_angle(block) - theta0);  // cosh of the time, less 1
  return std::log1p(x + std::sqrt(x * (2 + x))) / block_frequency(block);
}

double next_tilt(const RockingBlock& block, double theta0) {
  const double alpha = block_angle(block);
  const double r = rate_ratio(block);

  // It rises as far as it fell, times r²: first how far from toppling that leaves it
  const double fall = r * r * half_fall(alpha - theta0, theta0);
  const double s = std::sin(alpha / 2);
  const double short_of = 2 * std::asin(std::sqrt(s * s - fall));
  return 2 * std::asin(fall / std::sin((alpha + short_of) / 2));
}

}  // namespace timestep::exact
