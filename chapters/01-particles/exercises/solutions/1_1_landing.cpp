// The height v t - g t²/2 + g t dt/2 is zero at t = 2 v/g + dt. The ball lands one step
// late, after gravity has pulled for one step more: it comes back with energy that
// nobody put in, which is what (1.18) says of a spring.
#include "chapters/01-particles/exercises/1_1_landing.hpp"

namespace timestep {

Landing explicit_euler_landing(Real speed, Real g, Real dt) {
  return {.time = 2 * speed / g + dt, .speed = speed + g * dt};
}

}  // namespace timestep
