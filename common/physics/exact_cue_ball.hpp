/// @file
/// A ball that slides on a table until it rolls, and the cue that sets it off, in
/// double. The table is z = 0 with z up; x is the centre's place. Source: chapter 3;
/// Coriolis, Théorie mathématique des effets du jeu de billard (1835).
#pragma once

#include <glm/glm.hpp>

namespace timestep::exact {

/// A ball of the moment of inertia k m r², k = 2/5 if it is solid, on a table.
struct Ball {
  double mass;    ///< [kg], above 0
  double radius;  ///< r [m], above 0
  double k;       ///< above 0
  double mu;      ///< friction, not below 0
  double g;       ///< [m/s²], not below 0
};

/// Centre [m], velocity [m/s] and spin [rad/s], world frame.
struct BallMotion {
  glm::dvec3 x, v, omega;
};

/// (3.35) A ball at rest on the table at the origin, right after a level impulse J [N
/// s] along x that meets it `above` its centre and `aside` of it to the left, along y
/// [m].
BallMotion struck(const Ball& ball, double J, double above, double aside);

/// (3.35) What slips over the table: the velocity of the ball's lowest point [m/s].
glm::dvec3 slip(const Ball& ball, const BallMotion& now);

/// (3.35) From a motion on the table on, until the ball rolls [s]; infinite without
/// friction.
double time_until_rolling(const Ball& ball, const BallMotion& start);

/// (3.35) t >= 0 seconds later: friction against the slip, which keeps its direction,
/// then rolling without loss. What spins about the vertical goes on.
BallMotion slide_then_roll(const Ball& ball, const BallMotion& start, double t);

/// (3.35) How far above its centre to strike it so that it rolls at once [m].
double rolling_height(const Ball& ball);

}  // namespace timestep::exact
