// Conservative advancement (B. Mirtich, Impulse-based dynamic simulation of rigid body
// systems, 1996). The plane between the shapes stands still in A's frame, and B comes
// towards it with the part of the relative velocity along its normal. A wait can be too
// short, never too long. Glancing contacts take many: the normal turns as they come
// closer, and what was closing slowly closes faster.
//
// The wait aims at half of `within`. So the distance found is never 0, where the normal
// would be rounding's, and the last wait is not one of an endless row of ever shorter
// ones.
#include "chapters/04-contacts/exercises/4_3_time_of_impact.hpp"

namespace timestep {

std::optional<Real> time_of_impact(const Moving& a, const Moving& b, Real until,
                                   Real within) {
  constexpr int k_most = 1000;
  Real t = 0;
  for (int i = 0; i < k_most && t <= until; ++i) {
    // The plane between them, at this time
    Pose pose_a = a.pose, pose_b = b.pose;
    pose_a.position += t * a.velocity;
    pose_b.position += t * b.velocity;
    const Separation s = separation(a.shape, pose_a, b.shape, pose_b);
    if (s.distance <= within) return t;

    // How long it takes to close the gap along its normal
    const Real closing = glm::dot(s.normal, a.velocity - b.velocity);
    if (closing <= 0) return std::nullopt;
    t += (s.distance - within / 2) / closing;
  }
  return std::nullopt;
}

}  // namespace timestep
