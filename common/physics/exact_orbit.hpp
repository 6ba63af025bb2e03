/// @file
/// Exact orbits about a fixed centre, in double. Source: chapter 2.
#pragma once

#include "common/physics/exact.hpp"

namespace timestep::exact {

/// (2.27) Eccentric anomaly E [rad] from the mean anomaly M [rad] and the eccentricity
/// 0 <= e < 1: the root of Kepler's equation E - e sin E = M.
double eccentric_anomaly(double M, double e);

/// (2.28) The ellipse about GM = mu [m³/s²] with semi-major axis a [m] and eccentricity
/// e, in the plane z = 0, t seconds after the pericentre at (a (1 - e), 0, 0).
Motion orbit(double mu, double a, double e, double t);

/// What an orbit keeps, from where a body is and how fast [m, m/s].
struct OrbitElements {
  double energy;            ///< a unit of mass [J/kg]
  double angular_momentum;  ///< about z, a unit of mass [m²/s]
  double eccentricity;
  double pericentre;  ///< direction of the nearest point, angle from x [rad]
};

OrbitElements elements(double mu, const Motion& now);

}  // namespace timestep::exact
