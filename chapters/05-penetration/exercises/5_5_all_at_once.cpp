// Below are sweeps: contact by contact, what is left of each depth. For a few balls
// they will do. For a thousand they would have to be millions.
//
// Hints: write down by how much ball i rises, from the push below it and the one above.
// What is the difference between two neighbours? That is a linear system, whose matrix
// has three numbers in a row, on the diagonal and beside it. Gauss's elimination fills
// nothing in: eliminate upwards, put in downwards.
//
// Or look at the balls in place of the contacts. By how much must ball i rise? Who
// lifts all that is above a contact?
#include "chapters/05-penetration/exercises/5_5_all_at_once.hpp"

namespace timestep {

std::vector<Real> pushes(std::span<const Real> inverse_masses,
                         std::span<const Real> depths) {
  constexpr int k_sweeps = 100;
  const std::size_t n = depths.size();
  std::vector<Real> push(n, 0), rise(n, 0);
  for (int k = 0; k < k_sweeps; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const Real floor = i == 0 ? 0 : rise[i - 1];
      const Real below = i == 0 ? 0 : inverse_masses[i - 1];
      const Real more = (depths[i] - (rise[i] - floor)) / (inverse_masses[i] + below);
      push[i] += more;
      rise[i] += more * inverse_masses[i];
      if (i > 0) rise[i - 1] -= more * below;
    }
  }
  return push;
}

}  // namespace timestep
