// L in the world is never touched, only seen from a body that has turned, so it stays
// whatever the turn is. How good the motion is depends on the turn alone. Here it is
// Buss's (3.21), with an Euler step for the omega half-way; (3.24) and (3.25) find it
// in other ways. The energy is not kept: it drifts, but with dt² and not at all times
// upwards as with the omega of the start.
#include "chapters/03-rigid-bodies/exercises/3_3_free_step.hpp"

namespace timestep {

Vec3 angular_acceleration(const Vec3& omega, const Vec3& I, const Vec3& tau) {
  return (tau - glm::cross(omega, I * omega)) / I;
}

void free_step(Rotation& r, const Vec3& I, Real dt) {
  const Vec3 L = I * r.omega;
  const Vec3 half_way = r.omega + dt / 2 * angular_acceleration(r.omega, I, Vec3(0));
  const Quat turn = rotation_by(dt * half_way);

  r.q = glm::normalize(r.q * turn);
  r.omega = glm::conjugate(turn) * L / I;
}

}  // namespace timestep
