/// @file
/// What a scheme does to an oscillator, without running it: one step on x'' = -omega² x
/// is a matrix, and the matrix tells growth, limits, frequency, and the energy that the
/// scheme keeps in place of the true one. Source: chapter 2; E. Hairer, C. Lubich,
/// G. Wanner, Geometric Numerical Integration (2006), section I.5.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (x, v / omega) -> (xx x + xv v / omega, vx x + vv v / omega).
struct StepMatrix {
  double xx, xv, vx, vv;
};

/// (2.32) One step of a scheme at z = omega dt.
StepMatrix step_matrix(const Scheme& scheme, Real z);

/// (2.33) The factor by which the amplitude grows in a step in the long run: the
/// largest |eigenvalue|.
double spectral_radius(const StepMatrix& m);

/// (2.34) The largest z such that the scheme does not blow up below it; 0 if it grows
/// at every z (and so at 1/4), infinity if it never does (up to z = 100).
double stability_limit(const Scheme& scheme);

/// (2.35) xx x² + xv x v/omega + vv (v/omega)², in units of the stiffness: what the
/// scheme keeps to the last bit, if it keeps areas; 1/2, 0, 1/2 would be the energy.
struct ModifiedEnergy {
  double xx, xv, vv;
};
ModifiedEnergy modified_energy(const StepMatrix& m, double z);

/// (2.36) Between which multiples of the modified energy the true energy stays.
struct EnergyRange {
  double least, most;
};
EnergyRange energy_range(const ModifiedEnergy& h);

/// (2.37) The frequency that a scheme that keeps areas makes of omega, as the ratio to
/// it.
double frequency_ratio(const StepMatrix& m, double z);

}  // namespace timestep::inline TIMESTEP_PRECISION
