/// @file
/// What the tests of exercises share: a check that says in words what is wrong.
#pragma once

#include <cmath>
#include <string_view>

#include <fmt/format.h>

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

}  // namespace timestep
