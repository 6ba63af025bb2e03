#include "common/physics/exact_cue_ball.hpp"

#include <algorithm>
#include <limits>

namespace timestep::exact {
namespace {

// The ball once friction has taken the velocity `taken` from it
BallMotion slowed(const Ball& ball, BallMotion at, const glm::dvec3& taken) {
  at.v -= taken;
  at.omega += glm::dvec3(-taken.y, taken.x, 0.0) / (ball.k * ball.radius);
  return at;
}

}  // namespace

BallMotion struck(const Ball& ball, double J, double above, double aside) {
  const double I = ball.k * ball.mass * ball.radius * ball.radius;
  return {{0, 0, ball.radius},
          {J / ball.mass, 0, 0},
          glm::dvec3(0, above, -aside) * (J / I)};
}

glm::dvec3 slip(const Ball& ball, const BallMotion& now) {
  const auto& [x, v, omega] = now;
  return {v.x - ball.radius * omega.y, v.y + ball.radius * omega.x, 0};
}

double time_until_rolling(const Ball& ball, const BallMotion& start) {
  const double slipping = glm::length(slip(ball, start));
  if (slipping == 0) return 0;
  const double grip = ball.mu * ball.g * (1 + 1 / ball.k);
  return grip > 0 ? slipping / grip : std::numeric_limits<double>::infinity();
}

BallMotion slide_then_roll(const Ball& ball, const BallMotion& start, double t) {
  const double rolling = time_until_rolling(ball, start);
  const double sliding = std::min(t, rolling);
  if (sliding == 0) return {start.x + start.v * t, start.v, start.omega};

  // In rolling the slip is gone, of which the velocity has k / (1 + k)
  const glm::dvec3 slips = slip(ball, start);
  const glm::dvec3 taken = t < rolling ? ball.mu * ball.g * t * glm::normalize(slips)
                                       : slips * (ball.k / (1 + ball.k));
  BallMotion now = slowed(ball, start, taken);
  now.x += (start.v - taken / 2.0) * sliding + now.v * (t - sliding);
  return now;
}

double rolling_height(const Ball& ball) {
  return ball.k * ball.radius;
}

}  // namespace timestep::exact
