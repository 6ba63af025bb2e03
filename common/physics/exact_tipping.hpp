/// @file
/// What falls over, in double: rods that stand on an end, Painlevé's rod, and a block
/// that rocks. Angles of falling rods [rad] are from upright; a rod is thin and
/// uniform. Source: chapter 6; Painlevé, Sur les lois du frottement de glissement
/// (1895); Housner, The behavior of inverted pendulum structures during earthquakes
/// (1963).
#pragma once

namespace timestep::exact {

/// How long what tips as theta'' = omega0² sin theta takes from rest at `from` on by an
/// angle, from >= 0 and from + by <= pi [s]; infinite from 0, where it balances, and
/// from angles below 1e-150.
double tipping_time(double omega0, double from, double by);

/// A rod let go at rest at theta0, 0 <= theta0 <= theta < pi.
struct FallingRod {
  double mass, length;  ///< [kg], [m], above 0
  double g;             ///< [m/s²]
  double theta0;
};

/// Rate [rad/s] and angular acceleration [rad/s²] at theta, and the floor's forces on
/// the rod [N]: up, and friction in the direction in which the rod leans.
struct RodMotion {
  double omega, alpha, normal, friction;
};

/// With an end that does not slip: it turns about that end.
RodMotion rod_on_rough_floor(const FallingRod& rod, double theta);

/// With an end that slips without friction: its centre falls straight down. The floor
/// pushes all the way.
RodMotion rod_on_smooth_floor(const FallingRod& rod, double theta);

/// When the rod on a rough floor is at theta [s]; infinite if theta0 = 0.
double rod_time(const FallingRod& rod, double theta);

/// Let go upright on a rough floor: friction turns round at cos theta = 2/3 and nothing
/// presses on the floor at 1/3. On the way its end slips backwards unless mu is above
/// the most friction per normal force, at cos theta = 9/11.
struct UprightRod {
  double cos_friction_reverses = 2.0 / 3;
  double cos_normal_zero = 1.0 / 3;
  double cos_most_needed = 9.0 / 11;
  double mu_needed = 0.37057941330098193;  ///< 15 sqrt(10) / 128
};

/// A rod that slides on a rough floor on the end that leads, at an angle theta to the
/// floor, 0 <= theta <= pi/2: it leans back, as chalk that is pushed over a board. With
/// a normal force N that end's height has the second derivative b + p N.
struct PainleveRod {
  double mass, half_length;  ///< [kg], [m], above 0
  double g;                  ///< [m/s²], above 0
  double theta, omega;       ///< [rad], [rad/s]
  double mu;                 ///< not below 0
};

enum class Painleve {
  slides,         ///< b < 0 < p: pressed to the floor, N = -b / p
  parts,          ///< b, p >= 0: leaves the floor, N = 0
  inconsistent,   ///< b < 0, p <= 0: no force keeps it from sinking in; an impulse does
  indeterminate,  ///< p < 0 <= b: N = 0 and N = -b / p both serve
};

struct PainleveForces {
  double p;  ///< [1/kg]
  double b;  ///< [m/s²]
  Painleve state;
  double normal;  ///< [N]; infinite where there is no answer or no single one
};
PainleveForces painleve(const PainleveRod& rod);

/// The mu from which on p <= 0 at theta: without bound towards upright and flat, and
/// least, 4/3, at tan theta = 2.
double painleve_friction(double theta);

/// A block on a floor that it does not slip on, tilted about one corner and then the
/// other. Impacts end in one instant and keep the angular momentum about the corner
/// that hits.
struct RockingBlock {
  double half_width, half_height;  ///< [m], above 0
  double g;                        ///< [m/s²], above 0
};

/// Angle from its side to its diagonal [rad]: tilted further, it topples.
double block_angle(const RockingBlock& block);

/// sqrt(3 g / (4 R)) with R half the diagonal [rad/s].
double block_frequency(const RockingBlock& block);

/// Rate after an impact over that before, 1 - 3/2 sin² block_angle. At 0 it stops;
/// below 0, for blocks wider than sqrt(2) times their height, it would not rock on but
/// leap.
double rate_ratio(const RockingBlock& block);

/// From rest at a tilt theta0, 0 <= theta0 < block_angle, to the floor: time [s] and
/// rate [rad/s].
double quarter_time(const RockingBlock& block, double theta0);
double impact_rate(const RockingBlock& block, double theta0);

/// The same time as Housner has it for slender blocks, sin x = x.
double slender_quarter_time(const RockingBlock& block, double theta0);

/// The tilt that it reaches after that impact [rad].
double next_tilt(const RockingBlock& block, double theta0);

}  // namespace timestep::exact
