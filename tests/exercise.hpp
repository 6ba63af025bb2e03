/// @file
/// What the tests of exercises share: a check that says in words what is wrong.
#pragma once

#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <glm/glm.hpp>

#include "tests/catch.hpp"

namespace timestep {

/// Ends the test case with `what`, which names a quantity and its unit, unless `yours`
/// is within `tolerance` of `right`.
inline void expect(std::string_view what, double yours, double right,
                   double tolerance) {
  const double error = yours - right;
  if (std::abs(error) <= tolerance) return;
  FAIL(fmt::format("{}: yours is {:.8g}, right is {:.8g} (off by {:.1e})", what, yours,
                   right, error));
}

/// The same for each component of a vector.
inline void expect(std::string_view what, const glm::dvec3& yours,
                   const glm::dvec3& right, double tolerance) {
  for (const int i : {0, 1, 2})
    expect(fmt::format("{} of {}", "xyz"[i], what), yours[i], right[i], tolerance);
}

}  // namespace timestep
