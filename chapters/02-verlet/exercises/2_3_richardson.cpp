// A result is off by C dt^p, but nobody tells you the right answer X, nor C. Below p is
// taken to be 1, and the finest result to be right. Do better.
//
// Hint: write down the three results as X + C dt^p, X + C (dt/2)^p and X + C (dt/4)^p.
// Which differences do not contain X? What is the ratio of two of them?
#include "chapters/02-verlet/exercises/2_3_richardson.hpp"

namespace timestep {

Real observed_order([[maybe_unused]] Real coarse, [[maybe_unused]] Real middle,
                    [[maybe_unused]] Real fine) {
  return 1;
}

Real extrapolated([[maybe_unused]] Real coarse, Real fine, [[maybe_unused]] Real p) {
  return fine;
}

}  // namespace timestep
