#include "common/physics/exact_rolling.hpp"

#include <algorithm>
#include <cmath>

#include "common/physics/exact_pendulum.hpp"

namespace timestep::exact {

double rolling_friction_needed(const BallOnIncline& ball) {
  return std::tan(ball.angle) * ball.k / (1 + ball.k);
}

bool rolls(const BallOnIncline& ball) {
  return ball.mu >= rolling_friction_needed(ball);
}

BallAcceleration acceleration(const BallOnIncline& ball) {
  const double down = ball.g * std::sin(ball.angle);
  if (rolls(ball)) {
    const double linear = down / (1 + ball.k);
    return {linear, linear / ball.radius};
  }
  const double friction = ball.mu * ball.g * std::cos(ball.angle);
  return {down - friction, friction / (ball.k * ball.radius)};
}

double cos_leaving_angle(const BallOnBall& ball) {
  return 2 / (3 + ball.k);
}

// There gravity alone bends the path: v² / (R + r) = g cos
double leaving_speed(const BallOnBall& ball) {
  return std::sqrt(ball.g * (ball.big_radius + ball.radius) * cos_leaving_angle(ball));
}

double bowl_frequency(const BallInBowl& ball) {
  return std::sqrt(ball.g / ((1 + ball.k) * (ball.bowl_radius - ball.radius)));
}

Coordinate ball_in_bowl(const BallInBowl& ball, double theta0, double t) {
  return pendulum({theta0, 0}, bowl_frequency(ball), t);
}

double bowl_period(const BallInBowl& ball, double theta0) {
  return pendulum_period({theta0, 0}, bowl_frequency(ball));
}

double ground_friction(const BoxUnderBalls& scene) {
  return scene.mu * scene.g * (scene.box_mass + scene.balls * scene.ball_mass);
}

BoxUnderBallsMotion accelerations(const BoxUnderBalls& scene) {
  // Each ball resists as 2/7 of its mass would that the box carried
  constexpr double k_share = 2.0 / 7;
  const double moved = scene.box_mass + k_share * scene.balls * scene.ball_mass;
  const double box = std::max(scene.force - ground_friction(scene), 0.0) / moved;
  return {box, k_share * box};
}

}  // namespace timestep::exact
