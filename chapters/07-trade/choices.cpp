#include "chapters/07-trade/choices.hpp"

#include <numbers>

namespace timestep::inline TIMESTEP_PRECISION::chapter_07 {
namespace {

constexpr double k_60_hz = 1.0 / 60;
constexpr double k_ten_orbits = 10 * 2 * std::numbers::pi;  // [s] of a year of 2 pi s

// Ten boxes that fall onto each other have to stand as a column
Trade falling_blocks() {
  return {
      .name = "falling-blocks",
      .summary = "ten boxes fall onto each other and have to stand",
      .chapter = "06-impulses",
      .earlier = "stack",
      .frame = k_60_hz,
      .duration = 10,
      .settings = {{"gap", 0.05}},
      .parameters = {"n", "gap", "friction", "gravity"},
      .wishes = {{"penetration", 5e-3}, {"fallen", 0.5}},
      .options = {{"too_cheap", "substeps", 1, {{"substeps", 1}}},
                  {"good_enough", "substeps", 1, {{"substeps", 4}}},
                  {"costly", "substeps", 1, {{"substeps", 32}}}},
  };
}

Trade orbit() {
  return {
      .name = "orbit",
      .summary = "a planet has to be where it belongs after ten years",
      .chapter = "02-verlet",
      .earlier = "orbit",
      .frame = 1.0 / 15,
      .duration = k_ten_orbits,
      .settings = {},
      .parameters = {"eccentricity"},
      .wishes = {{"position_error_max", 1e-3}},
      .options = {{"too_cheap", "semi_implicit_euler", 1, {}},
                  {"good_enough", "dopri5", 1, {}},
                  {"costly", "dopri5", 8, {}}},
  };
}

Trade stiff_rope() {
  return {
      .name = "stiff-rope",
      .summary = "a rope swings down and must not stretch",
      .chapter = "02-verlet",
      .earlier = "rope",
      .frame = k_60_hz,
      .duration = 4,
      .settings = {},
      .parameters = {"particles", "mass", "gravity", "angle"},
      .wishes = {{"stretch_max", 1e-2}},
      .options = {{"too_cheap", "distance_constraints", 1, {{"iterations", 1}}},
                  {"good_enough", "distance_constraints", 16, {{"iterations", 1}}},
                  {"costly", "rk4", 50, {{"stiffness", 1e6}}}},
  };
}

}  // namespace

const std::vector<Trade>& trades() {
  static const std::vector<Trade> all{falling_blocks(), orbit(), stiff_rope()};
  return all;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_07
