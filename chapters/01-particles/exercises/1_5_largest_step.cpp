// Below is the limit (1.20) of a spring alone, solved for dt. Drag alone has the limit
// c dt/m = 2. Find the limit of both together, as one formula.
//
// Hint: at the limit every step turns the state into its opposite: x becomes -x and v
// becomes -v. Put that into (1.4) and solve for dt. Of the ways to write a root of
// a quadratic equation, take the one that subtracts nothing and survives k = 0.
#include "chapters/01-particles/exercises/1_5_largest_step.hpp"

#include <cmath>

namespace timestep {

Real largest_step(Real m, Real k, [[maybe_unused]] Real c) {
  return 2 * std::sqrt(m / k);
}

}  // namespace timestep
