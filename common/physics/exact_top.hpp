/// @file
/// Exact motions of tops, in double: free of torque for any three moments, and heavy
/// and symmetric about a fixed pivot. Source: chapter 3; van Zon and Schofield,
/// Numerical implementation of the exact dynamics of free rigid bodies (2007); Landau
/// and Lifshitz, Mechanics, sections 35 and 37.
#pragma once

#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep::exact {

/// How a body is turned and turns: q, of length 1, takes its frame to the world's;
/// omega [rad/s] is in its own frame.
struct Turning {
  glm::dquat q;
  glm::dvec3 omega;
};

/// (3.29)-(3.31) A body with the principal moments `inertia` [kg m²], all above 0 and
/// in any order, t seconds after the start without torque. Every motion is covered:
/// spheres and symmetric tops, steady spins, rest, the separatrix. The attitude is
/// right to a few tens of units of round-off of 1 + |omega| t, the angle turned by.
/// What is below 1e-60 of the largest component of omega counts as 0.
Turning free_top(const glm::dvec3& inertia, const Turning& start, double t);

/// Of the motion of omega in the body [rad/s].
struct FreeTopMotion {
  int circulating_axis;  ///< that omega goes round: of the most or the least moment
  double m;              ///< parameter of its elliptic functions, 1 on the separatrix
  double period;         ///< [s]; infinite if omega stays or goes to the middle axis
};

FreeTopMotion free_top_motion(const glm::dvec3& inertia, const glm::dvec3& omega);

/// (3.32) From one flip to the next [s]: half the period.
double flip_interval(const glm::dvec3& inertia, const glm::dvec3& omega);

/// A symmetric top about a fixed pivot: I1 [kg m²] about the pivot, across its axis, I3
/// along it, mass [kg], g [m/s²] down along world z, and l [m] from the pivot to the
/// centre of mass. I1 and I3 are above 0, the others not below.
struct HeavyTop {
  double I1, I3, mass, g, l;
};

/// (3.33) Rates [rad/s] at which a tilted top precesses steadily; the fast one is
/// infinite on the horizontal.
struct SteadyPrecession {
  double slow, fast;
};

/// (3.33) (I3 omega3)² - 4 I1 m g l cos theta, below 0 where no precession is steady.
double steady_discriminant(const HeavyTop& top, double theta, double omega3);

/// (3.33) For a tilt theta [rad] from upright and a spin omega3 [rad/s] about its own
/// axis; nothing where the spin is too slow.
std::optional<SteadyPrecession> steady_precession(const HeavyTop& top, double theta,
                                                  double omega3);

/// (3.33) The least spin [rad/s] that can precess steadily at theta; at theta = 0, the
/// one that keeps a sleeping top upright.
double least_steady_spin(const HeavyTop& top, double theta);

/// A heavy top let go at a tilt theta [rad], 0 to pi, that is not changing, while it
/// precesses at phi_rate and spins at omega3 about its own axis [rad/s]. phi = psi = 0.
struct HeavyTopStart {
  double theta, phi_rate, omega3;
};

/// Angles [rad] of q = Rz(phi) Rx(theta) Rz(psi), and the rates [rad/s] of the first
/// two. phi and psi count whole turns. sine: of theta, all digits of it next to hanging
/// too.
struct HeavyTopAngles {
  double theta, phi, psi, theta_rate, phi_rate, sine;
};

/// (3.34) For every start, steady ones too; below a tilt of 1e-150 rad it is upright
/// and stays so. Swinging right through upright or hanging adds pi to phi.
HeavyTopAngles heavy_top(const HeavyTop& top, const HeavyTopStart& start, double t);

/// The attitude and angular velocity that such angles are.
Turning turning(const HeavyTopAngles& angles, double omega3);

/// What theta [rad] goes between, and the period of its going [s]; infinite if it comes
/// to rest upright.
struct Nutation {
  double theta_min, theta_max, period;
};

Nutation nutation(const HeavyTop& top, const HeavyTopStart& start);

}  // namespace timestep::exact
