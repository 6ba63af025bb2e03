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

// A block that moves askew on a slope, once w has fallen to w0 exp(-s)
struct Askew {
  double a, k;   // [m/s²] downhill; friction over that
  double c, w0;  // [m/s] speed / (1 + w0²) at the start

  // Integral of exp(-n s)
  static double sum(double n, double s) { return n == 0 ? s : -std::expm1(-n * s) / n; }

  double time(double s) const {
    return c / a * (sum(k - 1, s) + w0 * w0 * sum(k + 1, s));
  }
  SlopeMotion at(double s) const {
    const double w = w0 * std::exp(-s), scale = c * c / a, square = w0 * w0;
    const double down = sum(2 * k - 2, s) - square * square * sum(2 * k + 2, s);
    const double across = sum(2 * k - 1, s) + square * sum(2 * k + 1, s);
    return {{scale * down, 2 * w0 * scale * across},
            c * std::exp((1 - k) * s) * glm::dvec2(1 - w * w, 2 * w)};
  }
};

// By bisection, as far as doubles go
double decay_at(const Askew& askew, double t) {
  constexpr double k_most = 700;
  double low = 0, high = 1e-3;
  while (high < k_most && askew.time(high) < t) high *= 2;
  for (double s = (low + high) / 2; s > low && s < high; s = (low + high) / 2)
    (askew.time(s) < t ? low : high) = s;
  return high;
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

SlopeMotion across_incline(const Incline& incline, const glm::dvec2& v0, double t) {
  const double a = incline.g * std::sin(incline.angle);
  const double b = incline.mu_kinetic * incline.g * std::cos(incline.angle);
  if (v0.y == 0) {
    const Coordinate down = on_incline(incline, v0.x, t);
    return {{down.x, 0}, {down.v, 0}};
  }
  if (a == 0) {
    const double stops = braking_time(glm::length(v0), b, 1);
    const double moves = std::min(t, stops);
    const glm::dvec2 v = t < stops ? v0 * (1 - t / stops) : glm::dvec2(0);
    return {(v0 + v) / 2.0 * moves, v};
  }

  // Mirrored if it moves to the other side
  const double speed = glm::length(v0), side = std::abs(v0.y);
  const double w0 = v0.x > 0 ? side / (speed + v0.x) : (speed - v0.x) / side;
  const Askew askew{a, b / a, speed / (1 + w0 * w0), w0};
  const double k = askew.k;
  const double stops =
      k > 1 ? askew.c / a * (1 / (k - 1) + w0 * w0 / (k + 1)) : k_infinity;
  SlopeMotion motion = askew.at(t < stops ? decay_at(askew, t) : k_infinity);
  if (t >= stops) motion.v = glm::dvec2(0);
  const glm::dvec2 mirror(1, v0.y > 0 ? 1 : -1);
  return {motion.x * mirror, motion.v * mirror};
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
