// Below, every body is unstable about y, a wobble grows as fast as the body turns, and
// it flips once a turn.
//
// Hints, with the moments in ascending order I1 < I2 < I3: turn at W about axis 2 in
// (3.14), and leave out products of the two small components. What is left is
//   omega1' = (I2 - I3)/I1 W omega3,  omega3' = (I1 - I2)/I3 W omega1.
//
// For the interval 2 K(kappa)/lambda, name the axes once more. Omega goes round axis 3,
// which is that of the largest moment if |L|² > 2 E I2, else that of the smallest. Then
//   lambda² = (|L|² - 2 E I1) (I3 - I2) / (I1 I2 I3),
//   kappa² = (2 E I3 - |L|²) (I2 - I1) / ((|L|² - 2 E I1) (I3 - I2)).
// By Gauss, K(kappa) = pi / (2 agm(1, sqrt(1 - kappa²))). The arithmetic-geometric mean
// agm(a, b) is what a and b both become when again and again a is replaced by (a + b)/2
// and b by sqrt(a b). Ten rounds are plenty, unless b is 0.
//
// Where the wobble is tiny, 1 - kappa² and |L|² - 2 E I2 are small differences of large
// numbers. Write both as sums over the squares of omega, and cancel on paper.
#include "chapters/03-rigid-bodies/exercises/3_5_flips.hpp"

#include <numbers>

namespace timestep {

int unstable_axis([[maybe_unused]] const Vec3& I) {
  return 1;
}

Real growth_rate([[maybe_unused]] const Vec3& I, Real W) {
  return W;
}

Real flip_interval([[maybe_unused]] const Vec3& I, const Vec3& omega) {
  return 2 * std::numbers::pi / glm::length(omega);
}

}  // namespace timestep
