// Three cases are tried; what fits none of them pushes at both contacts. That is also
// the answer on a border: there one of the two impulses is 0 but for rounding, and is
// kept from pulling.
//
// Box2D solves the two contacts of a box's edge like this, since a sweep over two
// contacts of one body, each of which lifts the other, converges slowly.
#include "chapters/06-impulses/exercises/6_5_two_contacts.hpp"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace timestep {

glm::dvec2 two_contacts(const glm::dmat2& K, const glm::dvec2& v) {
  // Neither, or one alone
  if (v.x >= 0 && v.y >= 0) return {0, 0};
  const double x = -v.x / K[0][0], y = -v.y / K[1][1];
  if (x >= 0 && v.y + K[0][1] * x >= 0) return {x, 0};
  if (y >= 0 && v.x + K[1][0] * y >= 0) return {0, y};

  // Both
  const double det = K[0][0] * K[1][1] - K[0][1] * K[1][0];
  const glm::dvec2 both(K[1][0] * v.y - K[1][1] * v.x, K[0][1] * v.x - K[0][0] * v.y);
  return glm::max(both / det, 0.0);
}

}  // namespace timestep
