/// @file
/// What flies freely: drag, rotation, the gyroscopic term, the inertia tensor. Source:
/// chapter 7.
#pragma once

#include "common/physics/precision.hpp"
#include "study/ingredients/comparison.hpp"

// Both precisions are named at once where one is compared with the other
namespace timestep::single_precision::ingredients {
study::Motion thrown_ball(double from);
}
namespace timestep::double_precision::ingredients {
/// A ball in free fall, thrown at 45 degrees and 10 m/s from so far [m] from the
/// origin. Its error is in m.
study::Motion thrown_ball(double from);

std::vector<study::Comparison> flight_comparisons();
}  // namespace timestep::double_precision::ingredients
namespace timestep::single_precision::ingredients {
std::vector<study::Comparison> flight_comparisons();
}
