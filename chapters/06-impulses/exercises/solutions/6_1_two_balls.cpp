// The impulse is along the line of centres, so that it turns neither ball, and each
// velocity across it stays. With the effective mass in place of a mass it is one
// formula for equal balls, for a marble and a planet, and for a wall.
#include "chapters/06-impulses/exercises/6_1_two_balls.hpp"

namespace timestep {

std::array<Vec3, 2> after_collision(const Ball& a, const Ball& b, Real e) {
  // (6.1)
  const Vec3 n = glm::normalize(b.position - a.position);
  const Real v_n = glm::dot(n, b.velocity - a.velocity);
  const Real k = a.inverse_mass + b.inverse_mass;
  if (v_n >= 0 || k == 0) return {a.velocity, b.velocity};

  // (6.4), (6.3), (6.8)
  const Vec3 J = -(1 + e) * v_n / k * n;
  return {a.velocity - a.inverse_mass * J, b.velocity + b.inverse_mass * J};
}

}  // namespace timestep
