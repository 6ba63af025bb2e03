// Below is Listing 3, (3.16): without torque nothing accelerates, and the body turns on
// at the angular velocity that it has. Energy and the length of L stay, to rounding.
// The direction of L does not, and no smaller step will mend that.
//
// Hints: write (3.14) first. For the step, do not use it to change omega. What stands
// still is L in the world; so remember I omega, turn the body, look at the same L from
// the body as it stands then, and divide by I. Turning with the omega of the start is
// of first order. For the second order turn with the omega half-way through the step,
// or with a good guess at it, which is where (3.14) comes in.
#include "chapters/03-rigid-bodies/exercises/3_3_free_step.hpp"

namespace timestep {

Vec3 angular_acceleration([[maybe_unused]] const Vec3& omega, const Vec3& I,
                          const Vec3& tau) {
  return tau / I;
}

void free_step(Rotation& r, [[maybe_unused]] const Vec3& I, Real dt) {
  r.q = glm::normalize(r.q * rotation_by(dt * r.omega));
}

}  // namespace timestep
