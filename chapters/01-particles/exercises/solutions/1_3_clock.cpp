// W. Kahan's summation of 1965: as good as a clock of twice the digits that is rounded
// once. A compiler that is allowed to reorder sums (-ffast-math) would simplify it
// away.
#include "chapters/01-particles/exercises/1_3_clock.hpp"

namespace timestep {

void tick(Clock& clock, float frame_time) {
  const float wanted = frame_time + clock.lost;
  const float sum = clock.time + wanted;

  // What the sum did not take in
  clock.lost = wanted - (sum - clock.time);
  clock.time = sum;
}

}  // namespace timestep
