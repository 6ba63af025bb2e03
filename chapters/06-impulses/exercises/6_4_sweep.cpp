// Below, each contact gives what it lacks, and never less than nothing. So what it once
// gave too much it cannot take back.
//
// Hints: (6.11) with u = 0. Compute the new sum first, keep that from going below 0,
// and apply the difference, which may well be negative.
#include "chapters/06-impulses/exercises/6_4_sweep.hpp"

#include <algorithm>

namespace timestep {

void sweep(std::span<const Real> inverse_masses, std::span<Real> velocities,
           std::span<Real> impulses) {
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    const Real k = inverse_masses[i] + inverse_masses[i + 1];
    if (k == 0) continue;
    const Real closing = velocities[i] - velocities[i + 1];
    const Real J = std::max(closing / k, Real(0));
    impulses[i] += J;
    velocities[i] -= inverse_masses[i] * J;
    velocities[i + 1] += inverse_masses[i + 1] * J;
  }
}

}  // namespace timestep
