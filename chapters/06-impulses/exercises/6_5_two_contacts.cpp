// Below, each contact is resolved as if the other were not there. Try it on a plank on
// two posts: each impulse lifts the other end.
//
// Hints: Each contact either pushes, and then its speed is 0 afterwards, or it does not
// push. That makes four cases. In each, what is unknown follows from one or two
// equations, and what the case did not ask for has to come out right: try them in turn.
// With a positive determinant exactly one case fits, but for borders between two, where
// rounding can make both fail by a little. Which case is then safe to take?
#include "chapters/06-impulses/exercises/6_5_two_contacts.hpp"

#include <glm/common.hpp>

namespace timestep {

glm::dvec2 two_contacts(const glm::dmat2& K, const glm::dvec2& v) {
  return glm::max(-v / glm::dvec2(K[0][0], K[1][1]), 0.0);
}

}  // namespace timestep
