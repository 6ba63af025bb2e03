/// @file
/// Exact motion of a heavy symmetric top about a fixed pivot, in double. Source:
/// chapter 3; Landau and Lifshitz, Mechanics, section 35.
#pragma once

#include <optional>

#include "common/physics/exact_top.hpp"

namespace timestep::exact {

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
