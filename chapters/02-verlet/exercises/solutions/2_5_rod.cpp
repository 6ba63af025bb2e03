// With the rod's last place at (1, 0) and the one before at (cos, -sin), the free step
// ends at (2 - cos, sin). For small angles the next one is smaller by its cube: a drag
// of the rate omega² dt, which is why ropes of (2.26) come to rest so nicely, and the
// more slowly the smaller the step.
//
// With the pull along the rod as it was, the next angle is the last one: (2 - cos - λ,
// sin) is on the circle where λ = 2 - 2 cos. In molecular dynamics this is called SHAKE
// (J.-P. Ryckaert, G. Ciccotti, H. Berendsen, J. Comput. Phys. 23 (1977) 327). It is
// symplectic, of second order, and for one rod it needs no iteration.
#include "chapters/02-verlet/exercises/2_5_rod.hpp"

#include <cmath>

#include "common/physics/particle.hpp"

namespace timestep {

Real next_angle(Real angle) {
  return std::atan2(std::sin(angle), 2 - std::cos(angle));
}

void hold(const DistanceConstraint& rod, std::span<const Real> inverse_mass,
          std::span<const Real> before, std::span<Real> x) {
  const auto& [i, j, length] = rod;
  const Vec3 along = at(before, j) - at(before, i);
  const Vec3 d = at(x, j) - at(x, i);

  // |d - s along| = length: the smaller of the two roots s
  const Real excess = glm::dot(d, d) - length * length;
  const Real p = glm::dot(d, along);
  const Real s = excess / (p + std::sqrt(p * p - glm::dot(along, along) * excess));

  // Each end takes its share, by inverse mass
  const Vec3 pull = s / (inverse_mass[i] + inverse_mass[j]) * along;
  put(x, i, at(x, i) + inverse_mass[i] * pull);
  put(x, j, at(x, j) - inverse_mass[j] * pull);
}

}  // namespace timestep
