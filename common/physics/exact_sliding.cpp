#include "common/physics/exact_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace timestep::exact {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

// Down the slope: friction acts up while the block slides down, and down while up
double acceleration(const Incline& incline, bool down) {
  const double friction = incline.mu_kinetic * std::cos(incline.angle);
  return incline.g * (std::sin(incline.angle) + (down ? -friction : friction));
}

Coordinate accelerated(double v0, double a, double t) {
  return {t * (v0 + a * t / 2), v0 + a * t};
}

// When friction mu g has taken a speed away, and the way until then
double braking_time(double speed, double mu, double g) {
  return speed == 0 ? 0 : std::abs(speed) / (mu * g);
}
double braking_way(double speed, double time) {
  return speed == 0 ? 0 : speed / 2 * time;
}

}  // namespace

double threshold_angle(double mu_static) {
  return std::atan(mu_static);
}

bool slides_from_rest(const Incline& incline) {
  return std::sin(incline.angle) > incline.mu_static * std::cos(incline.angle);
}

double sliding_acceleration(const Incline& incline) {
  return acceleration(incline, true);
}

double stop_time(const Incline& incline, double v0) {
  if (v0 == 0) return slides_from_rest(incline) ? k_infinity : 0;
  const double a = acceleration(incline, v0 > 0);
  return v0 * a < 0 ? -v0 / a : k_infinity;
}

Coordinate on_incline(const Incline& incline, double v0, double t) {
  const double stops = v0 == 0 ? 0 : stop_time(incline, v0);
  if (t < stops) return accelerated(v0, acceleration(incline, v0 > 0), t);
  const double x = braking_way(v0, stops);
  if (!slides_from_rest(incline)) return {x, 0};
  const Coordinate again = accelerated(0, sliding_acceleration(incline), t - stops);
  return {x + again.x, again.v};
}

double slide_angle(const BoxOnIncline& box) {
  return std::atan(box.mu);
}

double tip_angle(const BoxOnIncline& box) {
  return std::atan2(box.base, box.height);
}

double pressure_centre(const BoxOnIncline& box, double angle) {
  return box.height / 2 * std::tan(angle);
}

Stop cone_stop(const glm::dvec2& v, double mu, double g) {
  const double time = braking_time(glm::length(v), mu, g);
  return {{braking_way(v.x, time), braking_way(v.y, time)}, time};
}

Stop pyramid_stop(const glm::dvec2& v, double mu, double g) {
  const double x = braking_time(v.x, mu, g);
  const double y = braking_time(v.y, mu, g);
  return {{braking_way(v.x, x), braking_way(v.y, y)}, std::max(x, y)};
}

double overhang(double length, int i) {
  return length / (2.0 * i);
}

double overhang_of_all(double length, int n) {
  double sum = 0;
  for (int i = n; i > 0; --i) sum += 1.0 / i;
  return length / 2 * sum;
}

std::vector<double> resting_impulses(std::span<const double> masses, double g,
                                     double dt) {
  std::vector<double> all(masses.size());
  double above = 0;
  for (std::size_t i = masses.size(); i-- > 0;) {
    above += masses[i];
    all[i] = above * g * dt;
  }
  return all;
}

double sweep_factor(int n) {
  return std::pow(std::cos(std::numbers::pi / (2.0 * n)), 2);
}

}  // namespace timestep::exact
