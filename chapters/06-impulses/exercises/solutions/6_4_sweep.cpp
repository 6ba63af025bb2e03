// The clamp is on the sum. That is all the difference between a method that converges
// to the solution of all contacts together and one that converges to something else,
// which depends on the order of the contacts.
#include "chapters/06-impulses/exercises/6_4_sweep.hpp"

#include <algorithm>

namespace timestep {

void sweep(std::span<const Real> inverse_masses, std::span<Real> velocities,
           std::span<Real> impulses) {
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    const Real k = inverse_masses[i] + inverse_masses[i + 1];
    if (k == 0) continue;
    const Real closing = velocities[i] - velocities[i + 1];
    const Real before = impulses[i];
    impulses[i] = std::max(before + closing / k, Real(0));
    const Real J = impulses[i] - before;
    velocities[i] -= inverse_masses[i] * J;
    velocities[i + 1] += inverse_masses[i + 1] * J;
  }
}

}  // namespace timestep
