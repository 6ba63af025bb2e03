// On logarithmic axes (7.1) is a straight line, whose slope is the order. Two points
// give the line, and the line gives the step. It ends where (7.1) does: at long steps
// other terms come in, and at short ones rounding, where errors no longer shrink and
// the slope says so.
#include "chapters/07-trade/exercises/7_2_order.hpp"

#include <cmath>

namespace timestep {

Convergence convergence(const Trial& a, const Trial& b) {
  const Real order = std::log(a.error / b.error) / std::log(a.dt / b.dt);
  return {order, b.error / std::pow(b.dt, order)};
}

Real step_for(const Convergence& c, Real error) {
  if (!(c.order > 0)) return 0;
  return std::pow(error / c.constant, 1 / c.order);
}

}  // namespace timestep
