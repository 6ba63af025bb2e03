/// @file
/// The right way out, where there is one contact: of all motions that end the overlap,
/// the one for which the sum of m |moved|² + I turned² is the least. That is what an
/// impulse does, and the only answer that depends on nothing but the masses. In double,
/// by bisection. Source: chapter 5, after C. F. Gauss's principle of least constraint,
/// 1829.
#pragma once

#include "common/physics/precision.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {

/// A plank, in the plane.
struct Plank {
  double length, thickness;  ///< [m]
  double mass;               ///< [kg]
  double inertia;            ///< [kg m²] about its middle
};

/// Where it is over the ground: the height of its middle [m], and how steep it stands
/// [rad].
struct PlankPlace {
  double height, tilt;
};

/// How deep the plank's lower edge is [m].
double plank_depth(const Plank& plank, const PlankPlace& place);

/// Where a plank that is in the ground with one end, and stands up to a right angle,
/// goes.
PlankPlace plank_out(const Plank& plank, const PlankPlace& place);

/// A ball on a bar, in the plane: the ball's centre is `along` and `above` [m] from the
/// bar's middle, and the bar is as thick as 2 `half` [m].
struct BallOnBar {
  double ball_mass, radius;
  double bar_mass, bar_inertia, half;
  double along, above;
};

/// How the two part [m]: the bar turns by `turn` [rad], both move along its new normal,
/// the ball by `ball` and the bar by -`bar`.
struct Parting {
  double turn, ball, bar;
};
Parting ball_off_bar(const BallOnBar& pair);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
