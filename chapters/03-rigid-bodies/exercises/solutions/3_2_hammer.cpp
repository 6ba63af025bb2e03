// The centre of the whole is where both shifts together cost least. They cost
// m1 m2 / (m1 + m2) times the square of the distance between the two centres, which is
// also how two stars turn about each other. None of this asks whether a mass is
// positive, so a hole is a part like any other.
#include "chapters/03-rigid-bodies/exercises/3_2_hammer.hpp"

namespace timestep {

Vec3 moments_about(const Spread& body, const Vec3& point) {
  const Vec3 d = body.centre - point;
  return body.moments + body.mass * (Vec3(glm::dot(d, d)) - d * d);
}

Spread joined(const Spread& a, const Spread& b) {
  const Real mass = a.mass + b.mass;
  const Vec3 centre = (a.mass * a.centre + b.mass * b.centre) / mass;
  return {mass, centre, moments_about(a, centre) + moments_about(b, centre)};
}

Spread hammer(Real handle_mass, Real length, Real head_mass, const Vec3& head_size) {
  // (3.8) A cylinder without a radius, a box
  const Vec3 rod = handle_mass * length * length / 12 * Vec3(1, 1, 0);
  const Vec3 s2 = head_size * head_size;
  const Vec3 box = head_mass / 12 * Vec3(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y);

  return joined({handle_mass, {0, 0, length / 2}, rod},
                {head_mass, {0, 0, length}, box});
}

}  // namespace timestep
