// Below, nothing turns: a plank's end is as hard to lift as the whole plank. Mend it.
//
// Hints: an impulse J at an arm r changes the velocity by J / m and the angular
// velocity by the inverse inertia times r x J. How fast does the point itself move
// then? A point of a body that turns with omega moves at omega x r.
// `world_inverse_inertia(body)` is the matrix that you need.
//
// For `push_by`: if 1 N s moves the point at k metres a second, which push moves it by
// `length`?
#include "chapters/05-penetration/exercises/5_2_up_or_level.hpp"

namespace timestep {

Real inverse_mass_at(const RigidBody& body, [[maybe_unused]] const Vec3& arm,
                     [[maybe_unused]] const Vec3& normal) {
  return body.inverse_mass;
}

Motion push_by([[maybe_unused]] const RigidBody& body, [[maybe_unused]] const Vec3& arm,
               const Vec3& normal, Real length) {
  return {length * normal, Vec3(0)};
}

}  // namespace timestep
