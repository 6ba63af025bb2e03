// Below, every body gets the speed of one contact. But each contact asks for a speed of
// its own, and the body below is already on its way. Mend it.
//
// Hints: (5.4) is about the speed at which two bodies part. The floor stands still. How
// fast is the lowest body, how fast the next? The energy is a sum of squares; there is
// a formula for 1 + 4 + 9 + ..., or a loop.
//
// And mind the slop: what is no deeper gets no speed.
#include "chapters/05-penetration/exercises/5_3_pop.hpp"

namespace timestep {

Real speed_of(const Column& column, [[maybe_unused]] int number) {
  return column.beta / column.dt * column.depth;
}

Real energy_put_in(const Column& column) {
  const Real v = speed_of(column, 1);
  return Real(column.bodies) * column.mass * v * v / 2;
}

Real rise(const Column& column, Real gravity) {
  const Real v = speed_of(column, column.bodies);
  return v * v / (2 * gravity);
}

}  // namespace timestep
