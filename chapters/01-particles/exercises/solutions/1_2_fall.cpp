// The velocity decays as e^(-b t), as damping (1.10) lets it, while gravity acts for
// less than the whole step: it is itself forgotten at the same rate.
#include "chapters/01-particles/exercises/1_2_fall.hpp"

#include <cmath>

namespace timestep {

Vec3 fall_velocity(const Vec3& v, const Vec3& g, Real b, Real dt) {
  // The time that gravity acts for: (1 - e^(-b dt)) / b, which becomes dt without drag
  const Real time = b > 0 ? -std::expm1(-b * dt) / b : dt;

  return std::exp(-b * dt) * v + time * g;
}

}  // namespace timestep
