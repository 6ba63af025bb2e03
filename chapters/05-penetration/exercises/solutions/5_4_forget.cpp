// A velocity beside each bead's own. It starts at zero, since it has nothing to do with
// how the beads move, gets the impulses, moves the beads once, and ends with the step.
#include "chapters/05-penetration/exercises/5_4_forget.hpp"

#include <algorithm>

namespace timestep {

void step_beads(std::span<Bead> beads, Real beta, Real slop, Real dt, int sweeps) {
  std::vector<Real> impulses(beads.size(), 0), pseudo(beads.size(), 0);
  for (int k = 0; k < sweeps; ++k) {
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
      const Real w_a = beads[i].inverse_mass, w_b = beads[i + 1].inverse_mass;
      const Real beyond = depth_of(beads, i) - slop;
      if (beyond <= 0 || w_a + w_b == 0) continue;

      const Real missing = beta / dt * beyond - (pseudo[i + 1] - pseudo[i]);
      const Real before = impulses[i];
      impulses[i] = std::max(before + missing / (w_a + w_b), Real(0));
      pseudo[i] -= w_a * (impulses[i] - before);
      pseudo[i + 1] += w_b * (impulses[i] - before);
    }
  }
  for (std::size_t i = 0; i < beads.size(); ++i)
    beads[i].x += dt * (beads[i].v + pseudo[i]);
}

}  // namespace timestep
