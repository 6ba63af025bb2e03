// Below, a rod without gravity whirls on at its rate, and is held by (2.26). Both
// cannot be true: (2.26) is a drag. Find by how much it brakes, then take a rod that
// does not.
//
// Hints, for the angle: put the rod's last place on the x axis, and draw the place
// before, the free step 2 x - x_previous, and the circle.
//
// For the rod: in (2.2) all forces are those at x_n, at the start of the step. Along
// which line does the rod pull then? Move both ends along that line, the lighter one
// further, until the distance is right. That is a quadratic equation; of its two roots
// take the smaller movement.
#include "chapters/02-verlet/exercises/2_5_rod.hpp"

namespace timestep {

Real next_angle(Real angle) {
  return angle;
}

void hold(const DistanceConstraint& rod, std::span<const Real> inverse_mass,
          [[maybe_unused]] std::span<const Real> before, std::span<Real> x) {
  satisfy({&rod, 1}, inverse_mass, 1, x);
}

}  // namespace timestep
