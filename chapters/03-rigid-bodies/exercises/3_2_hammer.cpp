// Below, moments are the same about every point, two bodies are as one by adding what
// they have, and all of the hammer's mass sits in one point of its head.
//
// Hints: for an axis along x only the distance from that axis counts, y² + z². A body's
// moment is smallest about its own centre of mass, so a shift to another point adds.
// The centre of two bodies is the mean of theirs, weighted with their masses. About
// that point the moments add up. Those of a box are in (3.8), and those of a rod too:
// it is a cylinder without a radius.
#include "chapters/03-rigid-bodies/exercises/3_2_hammer.hpp"

namespace timestep {

Vec3 moments_about(const Spread& body, [[maybe_unused]] const Vec3& point) {
  return body.moments;
}

Spread joined(const Spread& a, const Spread& b) {
  return {a.mass + b.mass, a.centre + b.centre, a.moments + b.moments};
}

Spread hammer(Real handle_mass, Real length, Real head_mass,
              [[maybe_unused]] const Vec3& head_size) {
  return {handle_mass + head_mass, {0, 0, length}, {0, 0, 0}};
}

}  // namespace timestep
