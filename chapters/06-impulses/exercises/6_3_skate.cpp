// Below, friction is limited along the blade and across it separately. That is the
// pyramid (6.6): it allows impulses that the ellipse does not.
//
// Hints: The impulse that would end the slip is w = -m slip. The energy that is left
// after an impulse J is |J - w|² / 2 m, so what is asked for is the point of the
// ellipse closest to w. There, w - J is along the ellipse's normal: w_i - J_i = s J_i /
// a_i² with half axes a and some s > 0. Solve that for J, and find the s for which J
// lies on the ellipse. More s is more inside, so halving an interval will do.
#include "chapters/06-impulses/exercises/6_3_skate.hpp"

namespace timestep {

glm::dvec2 friction_impulse(const Skate& skate, const glm::dvec2& slip) {
  const glm::dvec2 most = skate.friction * skate.normal_impulse;
  return glm::clamp(-skate.effective_mass * slip, -most, most);
}

}  // namespace timestep
