// Below, the shapes are looked at sixty times a second, so that what is fast passes
// through what is thin. Find the time without looking that often.
//
// Hints: `separation(a.shape, …, b.shape, …)` gives the distance d and the normal n at
// any time. Until the gap along n is closed, they cannot touch, whatever else they do.
// How fast does that gap close? Wait until it would be closed, no longer, and ask
// again. Stop where they are close enough. If the gap along n does not close, it never
// will.
//
// Each wait is safe, but if it always ends exactly where the gap would be closed, what
// happens if the shapes touch at a glancing angle? Aim at a distance between `within`
// and 0, so that there is room for rounding.
#include "chapters/04-contacts/exercises/4_3_time_of_impact.hpp"

namespace timestep {

std::optional<Real> time_of_impact(const Moving& a, const Moving& b, Real until,
                                   Real within) {
  constexpr int k_steps = 60;
  for (int i = 0; i <= k_steps; ++i) {
    const Real t = until * i / k_steps;
    Pose pose_a = a.pose, pose_b = b.pose;
    pose_a.position += t * a.velocity;
    pose_b.position += t * b.velocity;
    if (separation(a.shape, pose_a, b.shape, pose_b).distance <= within) return t;
  }
  return std::nullopt;
}

}  // namespace timestep
