// Below, each body moves by half of the depth, and a feather lifts a bowling ball. Mend
// it.
//
// Hints: (5.2) has masses. Divide above and below by m_A m_B, and only inverse masses
// are left. Which of them goes with which body? Try it with a wall.
#include "chapters/05-penetration/exercises/5_1_who_moves.hpp"

namespace timestep {

Shares part([[maybe_unused]] Real inverse_mass_a, [[maybe_unused]] Real inverse_mass_b,
            Real depth, const Vec3& normal) {
  return {-depth / 2 * normal, depth / 2 * normal};
}

}  // namespace timestep
