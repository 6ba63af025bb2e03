// Below are Baumgarte's velocities (5.4), and the beads keep them. Make split impulses
// of them (5.5).
//
// Hints: which velocities should the sweeps look at, and change? Where do they start in
// each step, and what is left of them when the beads have moved? The beads' own
// velocities still move the beads.
#include "chapters/05-penetration/exercises/5_4_forget.hpp"

#include <algorithm>

namespace timestep {

void step_beads(std::span<Bead> beads, Real beta, Real slop, Real dt, int sweeps) {
  std::vector<Real> impulses(beads.size(), 0);
  for (int k = 0; k < sweeps; ++k) {
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
      Bead &a = beads[i], &b = beads[i + 1];
      const Real beyond = depth_of(beads, i) - slop;
      const Real masses = a.inverse_mass + b.inverse_mass;
      if (beyond <= 0 || masses == 0) continue;

      // What is missing to the speed at which they are to part; never a pull
      const Real missing = beta / dt * beyond - (b.v - a.v);
      const Real before = impulses[i];
      impulses[i] = std::max(before + missing / masses, Real(0));
      a.v -= a.inverse_mass * (impulses[i] - before);
      b.v += b.inverse_mass * (impulses[i] - before);
    }
  }
  for (Bead& bead : beads) bead.x += dt * bead.v;
}

}  // namespace timestep
