// The same law as (6.5), of the most dissipation: of all impulses that friction allows,
// the one that takes the most energy. For a circle the closest point is w scaled down.
// For an ellipse it is not: a skate that slips mostly along its blade is pushed mostly
// across, and so goes where the blade points.
//
// s lies between 0 and the size of w times the longer half axis, beyond which J is
// inside for sure.
#include "chapters/06-impulses/exercises/6_3_skate.hpp"

#include <algorithm>

namespace timestep {

glm::dvec2 friction_impulse(const Skate& skate, const glm::dvec2& slip) {
  const glm::dvec2 a = skate.friction * skate.normal_impulse;
  const glm::dvec2 w = -skate.effective_mass * slip;
  if (skate.normal_impulse == 0) return {0, 0};
  if (glm::length(w / a) <= 1) return w;

  double low = 0, high = glm::length(w) * std::max(a.x, a.y);
  for (int i = 0; i < 200; ++i) {
    const double s = (low + high) / 2;
    (glm::length(w * a / (a * a + s)) > 1 ? low : high) = s;
  }
  return w * a * a / (a * a + high);
}

}  // namespace timestep
