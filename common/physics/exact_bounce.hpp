/// @file
/// Bounces and impacts along one line, in double: a ball on the floor, rows of balls,
/// and a spring and damper in place of an impulse. Balls are listed from left to right,
/// or from the lowest up; velocities [m/s] are positive to the right, or up. Newton's
/// restitution e, 0 <= e <= 1, is the share of the closing speed that is left as
/// parting speed. Source: chapter 6; Goldsmith, Impact (1960).
#pragma once

#include <span>
#include <vector>

#include "common/physics/exact.hpp"

namespace timestep::exact {

/// A ball, or the lowest point of one, let go at a height above the floor.
struct BouncingBall {
  double height;  ///< [m], not below 0
  double e;
  double g;  ///< [m/s²], above 0
};

/// When the ball meets the floor for the n-th time, n >= 1 [s].
double impact_time(const BouncingBall& ball, int n);

/// How fast it leaves the floor then [m/s], and how high it rises after that [m].
double rebound_speed(const BouncingBall& ball, int n);
double apex_height(const BouncingBall& ball, int n);

/// All impacts are over by then [s]: infinitely many of them in a finite time. Infinite
/// if e = 1.
double rest_time(const BouncingBall& ball);

/// How far it goes up and down until it rests [m]; infinite if e = 1.
double total_distance(const BouncingBall& ball);

/// Height and velocity after t >= 0; from rest_time on it lies on the floor.
Coordinate bouncing_ball(const BouncingBall& ball, double t);

/// Velocities after the impacts between neighbours, and how many there were.
struct PairImpacts {
  std::vector<double> velocities;
  int impacts;
};

/// A row of balls that all but touch, by impacts of two at a time, the pair that closes
/// fastest first, until none closes by more than round-off. The order matters unless e
/// = 1 and all masses are equal. There may be infinitely many impacts (three equal
/// balls with e < 7 - 4 sqrt(3)): it stops after a million.
PairImpacts pair_impacts(std::span<const double> masses,
                         std::span<const double> velocities, double e);

/// Velocities after one impact, and the impulses between neighbours [N s].
struct RowImpact {
  std::vector<double> velocities, impulses;
};

/// The same row where all neighbours touch and act at once: each pair parts at e times
/// its closing speed. A pair that already parts takes no part, even if its neighbours
/// then make it close: that is another impact.
RowImpact row_impact(std::span<const double> masses, std::span<const double> velocities,
                     double e);

/// Balls on top of each other that all fall at one speed: the lowest bounces off the
/// floor, then off the next one, and so on up, each pair once. What then still moves
/// down has yet to meet the floor again.
std::vector<double> dropped_stack(std::span<const double> masses, double speed,
                                  double e);

/// A mass that meets a spring and a damper where others would apply an impulse:
/// m x'' = -k x - c x', x the depth.
struct PenaltyContact {
  double mass;  ///< [kg], above 0
  double k;     ///< [N/m], above 0
  double c;     ///< [N s/m], not below 0
};

/// How long after it meets them the mass turns back [s].
double penalty_turning_time(const PenaltyContact& contact);

/// How deep it is then [m], if it came at a speed [m/s].
double penalty_depth(const PenaltyContact& contact, double speed);

/// How long it touches [s] and the share of its speed that is left.
struct PenaltyBounce {
  double time, restitution;
};

/// Where contact ends as soon as the force would pull: after twice the turning time.
PenaltyBounce penalty_bounce(const PenaltyContact& contact);

/// Where the force may pull, and contact ends at depth 0; never (infinite, 0) from
/// critical damping on.
PenaltyBounce sticky_penalty_bounce(const PenaltyContact& contact);

}  // namespace timestep::exact
