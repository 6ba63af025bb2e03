// Below is the landing of a real ball: 2 v/g after the throw, as fast as it left.
// Explicit Euler's ball lands later and faster. Correct both, as formulas of v, g and
// dt.
//
// Hint: by (1.11) it is a t dt / 2 off the parabola (1.14), which for a throw means
// above it. When is the sum of the two zero? The velocity of explicit Euler has no
// error.
#include "chapters/01-particles/exercises/1_1_landing.hpp"

namespace timestep {

Landing explicit_euler_landing(Real speed, Real g, [[maybe_unused]] Real dt) {
  return {.time = 2 * speed / g, .speed = speed};
}

}  // namespace timestep
