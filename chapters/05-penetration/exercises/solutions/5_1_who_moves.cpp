// m_B / (m_A + m_B), divided by m_A m_B above and below, is (1/m_A) / (1/m_A + 1/m_B):
// each body's own inverse mass over the sum. The displacements times the masses add up
// to zero, so the centre of mass stays. Of a wall the share is 0, of whatever touches
// it
// 1. Two walls have no share at all: 0 / 0, which has to be said.
#include "chapters/05-penetration/exercises/5_1_who_moves.hpp"

namespace timestep {

Shares part(Real inverse_mass_a, Real inverse_mass_b, Real depth, const Vec3& normal) {
  const Real sum = inverse_mass_a + inverse_mass_b;
  if (sum == 0) return {Vec3(0), Vec3(0)};
  return {-inverse_mass_a / sum * depth * normal,
          inverse_mass_b / sum * depth * normal};
}

}  // namespace timestep
