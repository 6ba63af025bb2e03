// With h = dt/2 the new velocity solves (1 + h b + h q |v|) v = w, w = v_half + h g. It
// points along w, and its length s solves h q s² + (1 + h b) s = |w|. No drag is too
// strong: without gravity |w| is at most (1 + h b + h q s) s with the speed s before
// the step, so that the new speed cannot be larger. It may ring, though: beyond h b = 1
// the ball turns round in every step.
#include "chapters/02-verlet/exercises/2_4_drag.hpp"

#include <cmath>

namespace timestep {

void fall_step(Vec3& x, Vec3& v, const Vec3& g, Real b, Real q, Real dt) {
  const Real h = dt / 2;
  v += h * (g - (b + q * glm::length(v)) * v);
  x += dt * v;

  // The speed first, by the root that adds
  const Vec3 w = v + h * g;
  const Real linear = 1 + h * b;
  const Real speed =
      2 * glm::length(w)
      / (linear + std::sqrt(linear * linear + 4 * h * q * glm::length(w)));
  v = w / (linear + h * q * speed);
}

}  // namespace timestep
