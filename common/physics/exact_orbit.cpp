#include "common/physics/exact_orbit.hpp"

#include <cmath>
#include <numbers>

namespace timestep::exact {

double eccentric_anomaly(double M, double e) {
  // Whole turns apart, so that the sine is of a small angle
  const double turns = std::round(M / (2 * std::numbers::pi));
  const double m = std::remainder(M, 2 * std::numbers::pi);

  // (2.27) Newton from a start beyond the root, where it cannot overshoot
  double E = m == 0 ? 0 : std::copysign(std::numbers::pi, m);
  for (int i = 0; i < 60 && E != 0; ++i) {
    const double change = (E - e * std::sin(E) - m) / (1 - e * std::cos(E));
    E -= change;
    if (std::abs(change) <= 1e-16 * std::abs(E)) break;
  }
  return 2 * std::numbers::pi * turns + E;
}

Motion orbit(double mu, double a, double e, double t) {
  const double n = std::sqrt(mu / a) / a;  // mean motion [rad/s]
  const double E = eccentric_anomaly(n * t, e);
  const double b = a * std::sqrt((1 - e) * (1 + e));
  const double rate = n / (1 - e * std::cos(E));

  // (2.28) cos E - e = (1 - e) - (1 - cos E), which does not cancel near the pericentre
  const double s = std::sin(E / 2);
  return {{a * ((1 - e) - 2 * s * s), b * std::sin(E), 0},
          {-a * rate * std::sin(E), b * rate * std::cos(E), 0}};
}

OrbitElements elements(double mu, const Motion& now) {
  const auto& [x, v] = now;
  const double r = glm::length(x);
  const double L = x.x * v.y - x.y * v.x;

  // The Laplace-Runge-Lenz vector points to the pericentre, with the length e
  const glm::dvec2 lrl = glm::dvec2(v.y, -v.x) * L / mu - glm::dvec2(x.x, x.y) / r;
  return {.energy = glm::dot(v, v) / 2 - mu / r,
          .angular_momentum = L,
          .eccentricity = glm::length(lrl),
          .pericentre = std::atan2(lrl.y, lrl.x)};
}

}  // namespace timestep::exact
