// Below, the balls exchange their velocities. That is right for two balls of the same
// mass that meet head on and lose nothing, and for nothing else.
//
// Hints: the normal goes from one centre to the other. Along it, (6.1) without spins is
// how fast they part, and (6.2) without spins is the effective mass. (6.4) and (6.3)
// make an impulse of these; (6.8) gives each ball its share. Across the normal nothing
// happens.
#include "chapters/06-impulses/exercises/6_1_two_balls.hpp"

namespace timestep {

std::array<Vec3, 2> after_collision(const Ball& a, const Ball& b,
                                    [[maybe_unused]] Real e) {
  return {b.velocity, a.velocity};
}

}  // namespace timestep
