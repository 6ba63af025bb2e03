// Each body parts from the one below at the same speed u, so the first moves at u, the
// second at 2 u, and so on. That is why a pile pops so much higher than a box: the top
// body's height grows with the square of the pile's, the energy with its cube. Both are
// quadratic in beta / dt.
#include "chapters/05-penetration/exercises/5_3_pop.hpp"

#include <algorithm>

namespace timestep {

Real speed_of(const Column& column, int number) {
  const Real beyond = std::max(column.depth - column.slop, Real(0));
  return Real(number) * column.beta / column.dt * beyond;
}

Real energy_put_in(const Column& column) {
  Real energy = 0;
  for (int i = 1; i <= column.bodies; ++i) {
    const Real v = speed_of(column, i);
    energy += column.mass * v * v / 2;
  }
  return energy;
}

Real rise(const Column& column, Real gravity) {
  const Real v = speed_of(column, column.bodies);
  return v * v / (2 * gravity);
}

}  // namespace timestep
