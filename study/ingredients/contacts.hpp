/// @file
/// What touches: friction, rolling friction, the restitution threshold, manifolds, warm
/// start, substeps, and shapes in place of spheres. Source: chapter 7.
#pragma once

#include "common/physics/precision.hpp"
#include "study/ingredients/comparison.hpp"

namespace timestep::single_precision::ingredients {
std::vector<study::Comparison> surface_comparisons();
std::vector<study::Comparison> stack_comparisons();
std::vector<study::Comparison> pair_comparisons();
}  // namespace timestep::single_precision::ingredients

namespace timestep::double_precision::ingredients {
/// A ball or a block on a surface.
std::vector<study::Comparison> surface_comparisons();

/// Columns of boxes.
std::vector<study::Comparison> stack_comparisons();

/// How deep shapes are in each other.
std::vector<study::Comparison> pair_comparisons();
}  // namespace timestep::double_precision::ingredients
