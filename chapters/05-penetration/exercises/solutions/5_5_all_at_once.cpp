// Eliminating upwards and putting in downwards is, for this system, two sums. All
// depths end when ball i has risen by all depths below it, the floor's included: a sum
// upwards. The push below a ball has to lift it, and to hold against the push above:
// mass times rise, summed from the top downwards. No term is negative, so nothing
// cancels: each push is right to a few roundings a ball.
#include "chapters/05-penetration/exercises/5_5_all_at_once.hpp"

namespace timestep {

std::vector<Real> pushes(std::span<const Real> inverse_masses,
                         std::span<const Real> depths) {
  const std::size_t n = depths.size();
  std::vector<Real> rise(n, 0), push(n, 0);
  Real sum = 0;
  for (std::size_t i = 0; i < n; ++i) rise[i] = sum += depths[i];
  sum = 0;
  for (std::size_t i = n; i-- > 0;) push[i] = sum += rise[i] / inverse_masses[i];
  return push;
}

}  // namespace timestep
