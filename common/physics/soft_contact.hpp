/// @file
/// Contacts that give way a little, like a spring with a damper, and stay stable at any
/// stiffness. Source: chapter 6; E. Catto, Soft constraints, GDC 2011; E. Catto,
/// Solver2D, 2024.
#pragma once

#include <numbers>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (6.12) What implicit Euler makes of the spring in a step of h [s], so that
/// impulse = -mass_scale effective_mass (v + bias_rate s) - impulse_scale impulse.
struct SoftCoefficients {
  Real bias_rate = 0;      ///< [1/s] of a gap s, the speed that closes it
  Real mass_scale = 1;     ///< how hard it is: 1 is rigid
  Real impulse_scale = 0;  ///< how much of the impulse so far it lets go
};

/// (6.12) A contact of so many oscillations a second [Hz], with a share `damping_ratio`
/// of critical damping. Rigid without a bias for hertz = 0.
inline SoftCoefficients soft_contact(Real hertz, Real damping_ratio, Real h) {
  if (hertz == 0) return {};
  const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
  const Real a = 2 * damping_ratio + h * omega;
  const Real b = h * omega * a, c = 1 / (1 + b);
  return {omega / a, b * c, c};
}

/// The same spring and damper as forces.
struct SpringDamper {
  Real stiffness;  ///< k [N/m]
  Real damping;    ///< c [N s/m]
};
inline SpringDamper spring_damper(Real hertz, Real damping_ratio, Real effective_mass) {
  const Real omega = 2 * std::numbers::pi_v<Real> * hertz;
  return {effective_mass * omega * omega, 2 * effective_mass * damping_ratio * omega};
}

/// The same again as an error reduction and a constraint force mixing, which other
/// engines ask for.
struct ErpCfm {
  Real erp;  ///< the share of a gap that is closed in a step
  Real cfm;  ///< [m/(N s)] the speed that remains for a force
};
inline ErpCfm erp_cfm(const SpringDamper& spring, Real h) {
  const Real sum = spring.damping + h * spring.stiffness;
  return {h * spring.stiffness / sum, 1 / sum};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
