#include "common/physics/distance_constraint.hpp"

#include "common/physics/particle.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

void satisfy(std::span<const DistanceConstraint> constraints,
             std::span<const Real> inverse_mass, int iterations, std::span<Real> x) {
  for (int k = 0; k < iterations; ++k) {
    for (const auto& [i, j, length] : constraints) {
      const Real w = inverse_mass[i] + inverse_mass[j];
      const Vec3 d = at(x, j) - at(x, i);
      const Real distance = glm::length(d);
      if (w == 0 || distance == 0) continue;

      // (2.26) Each takes its share of the excess, by inverse mass
      const Vec3 excess = d * ((distance - length) / (distance * w));
      put(x, i, at(x, i) + inverse_mass[i] * excess);
      put(x, j, at(x, j) - inverse_mass[j] * excess);
    }
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION
