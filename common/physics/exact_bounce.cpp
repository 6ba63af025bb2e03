#include "common/physics/exact_bounce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/physics/exact_elliptic.hpp"

namespace timestep::exact {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

double fall_time(const BouncingBall& ball) {
  return std::sqrt(2 * ball.height / ball.g);
}

// e + e² + … + e^n, without cancellation for e close to 1
double powers(double e, int n) {
  if (n == 0 || e == 1) return n;
  return -e * std::expm1(n * std::log(e)) / (1 - e);
}

// How many impacts there are up to the time t, which is before the last; no more than a
// billion
int impacts_until(const BouncingBall& ball, double t) {
  const double first = fall_time(ball);
  if (t < first) return 0;
  double flights = (t - first) / (2 * first);
  if (ball.e < 1) {
    const double left = std::max(1 - flights * (1 - ball.e) / ball.e, 0.0);
    flights = std::log(left) / std::log(ball.e);
  }
  return 1 + static_cast<int>(std::min(flights, 1e9));
}

// Two balls, one after the other, by Newton's restitution
void collide(double m1, double& v1, double m2, double& v2, double e) {
  const double closing = v1 - v2;
  v1 -= (1 + e) * m2 / (m1 + m2) * closing;
  v2 += (1 + e) * m1 / (m1 + m2) * closing;
}

// The first ball of the pair that closes fastest; of pairs alike to rounding, the left
std::size_t closes_fastest(std::span<const double> v) {
  std::size_t pair = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i)
    if (v[i] - v[i + 1] > (1 + 1e-12) * (v[pair] - v[pair + 1])) pair = i;
  return pair;
}

// Impulses between neighbours that act on each other, from pair `begin` up to `end`:
// -x[i-1] / m[i] + (1 / m[i] + 1 / m[i+1]) x[i] - x[i+1] / m[i+1] = gain[i]
void solve_run(std::span<const double> m, std::span<const double> gain,
               std::size_t begin, std::size_t end, std::vector<double>& x) {
  // By elimination (Thomas). `left` is the inverse mass of a ball and all that it
  // pushes to its left, which a difference of pivots could not tell
  std::vector<double> pivot(end);
  double left = 1 / m[begin];
  for (std::size_t i = begin; i < end; ++i) {
    pivot[i] = left + 1 / m[i + 1];
    x[i] = gain[i] + (i > begin ? x[i - 1] / (m[i] * pivot[i - 1]) : 0);
    left *= 1 / m[i + 1] / pivot[i];
  }
  for (std::size_t i = end; i-- > begin;)
    x[i] = (x[i] + (i + 1 < end ? x[i + 1] / m[i + 1] : 0)) / pivot[i];
}

}  // namespace

double impact_time(const BouncingBall& ball, int n) {
  return fall_time(ball) * (1 + 2 * powers(ball.e, n - 1));
}

double rebound_speed(const BouncingBall& ball, int n) {
  return std::pow(ball.e, n) * std::sqrt(2 * ball.g * ball.height);
}

double apex_height(const BouncingBall& ball, int n) {
  return std::pow(ball.e, 2.0 * n) * ball.height;
}

double rest_time(const BouncingBall& ball) {
  return ball.e < 1 ? fall_time(ball) * (1 + ball.e) / (1 - ball.e) : k_infinity;
}

double total_distance(const BouncingBall& ball) {
  if (ball.e == 1) return k_infinity;
  return ball.height * (1 + ball.e * ball.e) / ((1 - ball.e) * (1 + ball.e));
}

Coordinate bouncing_ball(const BouncingBall& ball, double t) {
  if (ball.height == 0 || t >= rest_time(ball)) return {0, 0};
  const int n = impacts_until(ball, t);
  if (n == 0) return {ball.height - ball.g * t * t / 2, -ball.g * t};

  // Since the last impact; rounding may place it a hair on either side
  const double speed = rebound_speed(ball, n);
  const double since = std::clamp(t - impact_time(ball, n), 0.0, 2 * speed / ball.g);
  return {since * (speed - ball.g * since / 2), speed - ball.g * since};
}

PairImpacts pair_impacts(std::span<const double> masses,
                         std::span<const double> velocities, double e) {
  constexpr int k_most = 1000000;
  PairImpacts now{{velocities.begin(), velocities.end()}, 0};
  std::vector<double>& v = now.velocities;

  // A pair closes if it does so by more than what rounding may have left
  double fastest = 0;
  for (const double each : v) fastest = std::max(fastest, std::abs(each));
  const double least = 64 * std::numeric_limits<double>::epsilon() * fastest;
  for (; now.impacts < k_most; ++now.impacts) {
    const std::size_t i = closes_fastest(v);
    if (i + 1 >= v.size() || !(v[i] - v[i + 1] > least)) break;
    collide(masses[i], v[i], masses[i + 1], v[i + 1], e);
  }
  return now;
}

RowImpact row_impact(std::span<const double> masses, std::span<const double> velocities,
                     double e) {
  RowImpact now{{velocities.begin(), velocities.end()}, {}};
  auto& [v, x] = now;
  const std::size_t pairs = v.empty() ? 0 : v.size() - 1;
  x.resize(pairs);

  // What each pair gains in speed: what closes leaves with e times that
  std::vector<double> gain(pairs);
  for (std::size_t i = 0; i < pairs; ++i) gain[i] = (1 + e) * (v[i] - v[i + 1]);

  // Pairs that part separate the runs of those that act on each other
  for (std::size_t begin = 0, end = 0; begin < pairs; begin = end + 1) {
    end = begin;
    while (end < pairs && gain[end] >= 0) ++end;
    solve_run(masses, gain, begin, end, x);
  }
  for (std::size_t i = 0; i < pairs; ++i) {
    v[i] -= x[i] / masses[i];
    v[i + 1] += x[i] / masses[i + 1];
  }
  return now;
}

std::vector<double> dropped_stack(std::span<const double> masses, double speed,
                                  double e) {
  std::vector<double> v(masses.size(), -speed);
  if (!v.empty()) v[0] = e * speed;
  for (std::size_t i = 1; i < v.size(); ++i)
    collide(masses[i - 1], v[i - 1], masses[i], v[i], e);
  return v;
}

// The arc tangent of sqrt(1 - zeta²) / zeta over sqrt(1 - zeta²), or the hyperbolic one
// beyond critical damping: Carlson's R_C is both
double penalty_turning_time(const PenaltyContact& contact) {
  const double gamma = contact.c / (2 * contact.mass);
  return carlson_rc(gamma * gamma, contact.k / contact.mass);
}

double penalty_depth(const PenaltyContact& contact, double speed) {
  const double omega = std::sqrt(contact.k / contact.mass);
  return speed / omega * std::sqrt(penalty_bounce(contact).restitution);
}

PenaltyBounce penalty_bounce(const PenaltyContact& contact) {
  const double time = 2 * penalty_turning_time(contact);
  return {time, std::exp(-contact.c / (2 * contact.mass) * time)};
}

PenaltyBounce sticky_penalty_bounce(const PenaltyContact& contact) {
  const double gamma = contact.c / (2 * contact.mass);
  const double omega = std::sqrt(contact.k / contact.mass);
  if (gamma >= omega) return {k_infinity, 0};
  const double time = std::numbers::pi / std::sqrt((omega - gamma) * (omega + gamma));
  return {time, std::exp(-gamma * time)};
}

}  // namespace timestep::exact
