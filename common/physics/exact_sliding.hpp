/// @file
/// Sliding with Coulomb's friction, and what stands by its weight alone, in double.
/// Source: chapter 6; Coulomb, Théorie des machines simples (1785); Hall, Fun with
/// stacking blocks (2005).
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "common/physics/exact.hpp"

namespace timestep::exact {

/// A block on a plane inclined by 0 <= angle <= pi/2 [rad].
struct Incline {
  double angle;
  double mu_static;   ///< mu_kinetic or above
  double mu_kinetic;  ///< not below 0
  double g;           ///< [m/s²], above 0
};

/// The steepest angle at which a block at rest stays so [rad].
double threshold_angle(double mu_static);

bool slides_from_rest(const Incline& incline);

/// Acceleration down the slope while the block slides down [m/s²]; below 0 it slows.
double sliding_acceleration(const Incline& incline);

/// When a block with the speed v0 down the slope stops for the first time [s]: infinite
/// if it never does, 0 if it rests.
double stop_time(const Incline& incline, double v0);

/// Way [m] and speed [m/s] down the slope t >= 0 seconds after the speed v0. What stops
/// stays, or slides down again if the slope is too steep for it.
Coordinate on_incline(const Incline& incline, double v0, double t);

/// Place [m] and velocity [m/s] on the slope: down it, and across.
struct SlopeMotion {
  glm::dvec2 x, v;
};

/// The same from a velocity in any direction of the slope, t >= 0 seconds later. With
/// phi the velocity's angle from downhill and w = tan(phi / 2), Newton's law has the
/// speed go as (1 + w²) w^(k - 1), k = mu_kinetic / tan angle, and dt as minus the
/// speed times dw / w.
SlopeMotion across_incline(const Incline& incline, const glm::dvec2& v0, double t);

/// A box on its base that leans on a slope: it slides or tips, whichever angle is less.
struct BoxOnIncline {
  double base, height;  ///< along the slope and off it [m], above 0
  double mu;
};
double slide_angle(const BoxOnIncline& box);  ///< [rad]
double tip_angle(const BoxOnIncline& box);    ///< [rad]

/// How far down the slope from the base's middle its pressure acts [m].
double pressure_centre(const BoxOnIncline& box, double angle);

/// Where [m] and when [s] a body that slides on a level floor with the velocity v
/// stops; both infinite if mu = 0.
struct Stop {
  glm::dvec2 x;
  double time;
};

/// By the friction cone: mu g against the velocity, in a straight line.
Stop cone_stop(const glm::dvec2& v, double mu, double g);

/// By the pyramid that bounds x and y each on its own: up to sqrt(2) too strong, along
/// a bent path.
Stop pyramid_stop(const glm::dvec2& v, double mu, double g);

/// How far n blocks of a length, all alike, one on the other, reach over an edge [m]:
/// the offset of the i-th from the top, i >= 1, over what is below it, and of all.
double overhang(double length, int i);
double overhang_of_all(double length, int n);

/// What carries a pile of masses [kg], lowest first, for a time dt [s] against g: the
/// impulse [N s] below each.
std::vector<double> resting_impulses(std::span<const double> masses, double g,
                                     double dt);

/// What a sweep of Gauss-Seidel leaves of the error of these impulses in the end, in a
/// pile of n equal masses: cos²(pi / (2 n)). Source: Young, Iterative Solution of Large
/// Linear Systems (1971).
double sweep_factor(int n);

}  // namespace timestep::exact
