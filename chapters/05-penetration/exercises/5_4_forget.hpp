/// @file
/// Exercise 5.4, core: A velocity to forget
#pragma once

#include <span>
#include <vector>

#include "common/physics/real.hpp"

namespace timestep {

/// A ball that can move along a line only. One of inverse mass 0 does not move.
struct Bead {
  Real x, v;          ///< [m], [m/s]
  Real inverse_mass;  ///< [1/kg]
  Real radius;        ///< [m]
};

/// How deep [m] bead i + 1 is in bead i; negative across a gap.
inline Real depth_of(std::span<const Bead> beads, std::size_t i) {
  return beads[i].radius + beads[i + 1].radius - (beads[i + 1].x - beads[i].x);
}

/// (5.5) A step of dt [s] of beads in a row: whatever is deeper than `slop` [m] parts,
/// by the share `beta` of what is beyond it. Velocities are as before.
void step_beads(std::span<Bead> beads, Real beta, Real slop, Real dt, int sweeps);

}  // namespace timestep
