#include "common/physics/exact_orbit.hpp"

#include <cmath>
#include <numbers>

namespace timestep::exact {
namespace {

// E - sin E, by its series where the difference would cancel
double less_sine(double E) {
  if (std::abs(E) > 1) return E - std::sin(E);
  double term = E * E * E / 6;
  double sum = 0;
  for (int k = 4; k < 24; k += 2) {
    sum += term;
    term *= -E * E / (k * (k + 1));
  }
  return sum;
}

// 1 - e cos E, the distance in units of a
double distance(double E, double e) {
  const double s = std::sin(E / 2);
  return (1 - e) + 2 * e * s * s;
}

// E of |M| <= pi: what is left of M once whole turns are taken away
double within_a_turn(double M, double e) {
  if (M == 0) return 0;

  // (2.27) Newton from a start beyond the root, where it cannot overshoot
  double E = std::copysign(std::numbers::pi, M);
  for (int i = 0; i < 60; ++i) {
    const double change = ((1 - e) * E + e * less_sine(E) - M) / distance(E, e);
    E -= change;
    if (std::abs(change) <= 1e-16 * std::abs(E)) break;
  }
  return E;
}

// The angle without its whole turns; 2 pi is a double and what that lacks
double without_turns(double angle) {
  constexpr double k_lacks = 2.4492935982947064e-16;
  const double turns = std::round(angle / (2 * std::numbers::pi));
  return std::fma(-turns, 2 * std::numbers::pi, angle) - turns * k_lacks;
}

}  // namespace

double eccentric_anomaly(double M, double e) {
  const double m = without_turns(M);
  return (M - m) + within_a_turn(m, e);
}

Motion orbit(double mu, double a, double e, double t) {
  const double n = std::sqrt(mu / a) / a;  // mean motion [rad/s]
  const double E = within_a_turn(without_turns(n * t), e);
  const double b = a * std::sqrt((1 - e) * (1 + e));
  const double rate = n / distance(E, e);

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
