// Below is (2.9): the last half kick takes the drag of the half-step velocity, which
// costs an order, and explodes where drag is fierce. The engine's verlet_implicit finds
// the velocity at the end by Newton's method. For these forces it has a formula.
//
// Hints: begin with q = 0. Bring all that has the new velocity to one side; a division
// is left. With q, everything that multiplies the new velocity is a number, so its
// direction is known at once, and its length solves a quadratic equation. Write the
// root so that it subtracts nothing and survives q = 0, and let a ball at rest stay a
// number.
#include "chapters/02-verlet/exercises/2_4_drag.hpp"

namespace timestep {

void fall_step(Vec3& x, Vec3& v, const Vec3& g, Real b, Real q, Real dt) {
  v += dt / 2 * (g - (b + q * glm::length(v)) * v);
  x += dt * v;
  v += dt / 2 * (g - (b + q * glm::length(v)) * v);
}

}  // namespace timestep
