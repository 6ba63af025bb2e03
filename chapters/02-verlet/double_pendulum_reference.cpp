#include "chapters/02-verlet/double_pendulum_reference.hpp"

#if defined(TIMESTEP_DOUBLE)

#include <algorithm>
#include <cmath>

#include "common/physics/dormand_prince.hpp"
#include "common/physics/systems.hpp"

namespace timestep::double_precision::chapter_02 {

void advance(ReferencePendulum& pendulum, double dt, double tolerance) {
  auto& [m1, m2, l1, l2, g, theta, omega] = pendulum;
  const DoublePendulum system{m1, m2, l1, l2, g};

  const auto acceleration = [&](auto x, auto v, double, auto a) {
    double_pendulum(system, x, v, a);
  };

  State state{{theta.begin(), theta.end()}, {omega.begin(), omega.end()}, {0, 0}};

  // (2.21) A system too fast to follow becomes NaN, and the method gives up
  dormand_prince(state, acceleration, 0, dt, {tolerance, tolerance, 30'000});
  std::ranges::copy(state.x, theta.begin());
  std::ranges::copy(state.v, omega.begin());
}

double energy_above_rest(const ReferencePendulum& pendulum) {
  const auto& [m1, m2, l1, l2, g, theta, omega] = pendulum;
  const double kinetic = energy(DoublePendulum{m1, m2, l1, l2, 0}, theta, omega);

  // 1 - cos theta = 2 sin² (theta / 2), without cancellation
  const auto raised = [](double angle) { return 2 * std::pow(std::sin(angle / 2), 2); };
  return kinetic + g * ((m1 + m2) * l1 * raised(theta[0]) + m2 * l2 * raised(theta[1]));
}

}  // namespace timestep::double_precision::chapter_02

#endif
