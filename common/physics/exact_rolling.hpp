/// @file
/// Balls that roll, in double: down a slope, off a ball, in a bowl, under a box. The
/// moment of inertia of all is k m r². Source: chapter 6; Routh, Dynamics of a System
/// of Rigid Bodies (1905), part I.
#pragma once

#include "common/physics/exact.hpp"

namespace timestep::exact {

/// A ball at rest at the top of a slope of 0 <= angle <= pi/2 [rad].
struct BallOnIncline {
  double angle;
  double radius;  ///< [m], above 0
  double k;       ///< above 0
  double mu;      ///< not below 0
  double g;       ///< [m/s²]
};

/// The least mu with which it rolls, k / (1 + k) tan angle; with less it slips as well.
double rolling_friction_needed(const BallOnIncline& ball);
bool rolls(const BallOnIncline& ball);

/// Of its centre, down the slope [m/s²], and of its spin [rad/s²].
struct BallAcceleration {
  double linear, angular;
};
BallAcceleration acceleration(const BallOnIncline& ball);

/// A ball that starts at rest on top of a larger one that is held, and rolls or, with
/// k = 0, slides off it without friction.
struct BallOnBall {
  double big_radius, radius;  ///< [m], above 0
  double k;                   ///< not below 0
  double g;                   ///< [m/s²]
};

/// Where it leaves: the cosine of the angle from the top, 2 / (3 + k), the same for all
/// sizes and all g; and how fast [m/s]. Before that, where the normal force fades, no
/// friction holds it: to roll until then takes a mu without bound.
double cos_leaving_angle(const BallOnBall& ball);
double leaving_speed(const BallOnBall& ball);

/// A ball let go in a bowl: a pendulum of length (1 + k) (bowl_radius - radius).
struct BallInBowl {
  double bowl_radius, radius;  ///< [m], bowl_radius above radius
  double k;                    ///< not below 0; 0 slides without friction
  double g;                    ///< [m/s²], above 0
};

/// Frequency of small swings [rad/s].
double bowl_frequency(const BallInBowl& ball);

/// Where its centre is t seconds after rest at theta0, seen from the bowl's centre: the
/// angle from straight down [rad] and its rate [rad/s].
Coordinate ball_in_bowl(const BallInBowl& ball, double theta0, double t);
double bowl_period(const BallInBowl& ball, double theta0);  ///< [s]

/// SimBenchmark's rolling test: a box is pulled along the ground, with solid balls at
/// rest on top that roll as it moves under them. Source: Kang and Hwangbo, SimBenchmark
/// (2018).
struct BoxUnderBalls {
  double box_mass, ball_mass;  ///< [kg], above 0
  int balls;
  double force;  ///< level, on the box [N], not below 0
  double mu;     ///< of the box on the ground
  double g;      ///< [m/s²]
};

/// What the ground's friction is at most [N].
double ground_friction(const BoxUnderBalls& scene);

/// Accelerations from rest [m/s²] of the box and of each ball, 2/7 of the box's; 0 if
/// the ground holds the box. The balls need friction of box 2/7 / g to roll.
struct BoxUnderBallsMotion {
  double box, ball;
};
BoxUnderBallsMotion accelerations(const BoxUnderBalls& scene);

}  // namespace timestep::exact
