/// @file
/// Exact motions to measure against: closed forms, always in double. None of them is
/// stepped; the one integral that has no closed form is a quadrature to round-off.
/// Positions in metres, velocities in metres a second, world frame. Source: chapter 1.
#pragma once

#include <glm/glm.hpp>

namespace timestep::exact {

struct Motion {
  glm::dvec3 x, v;
};

/// (1.14) Constant acceleration a [m/s²] for a time t [s].
Motion constant_acceleration(const Motion& start, const glm::dvec3& a, double t);

/// (1.15) Gravity g [m/s²] and linear drag with the rate b = c/m [1/s]. b = 0 is the
/// case above; accurate to round-off for every b >= 0.
Motion linear_drag(const Motion& start, const glm::dvec3& g, double b, double t);

/// (1.16) Gravity g and quadratic drag with k/m [1/m]. The path in its vertical plane
/// by the slope of the velocity (Johann Bernoulli, 1719): speed in closed form, time
/// and place by Gauss quadrature; straight up and down all in closed form.
Motion quadratic_drag(const Motion& start, const glm::dvec3& g, double k_over_m,
                      double t);

/// One coordinate and its rate.
struct Coordinate {
  double x, v;
};

/// (1.17) x'' = -omega² x - 2 gamma x' for every omega, gamma >= 0 [1/s]: under-, over-
/// and critically damped.
Coordinate oscillator(const Coordinate& start, double omega, double gamma, double t);

}  // namespace timestep::exact
