/// @file
/// Model only what a scene requires: what each ingredient costs, and which error its
/// absence causes, in a scene that requires it and in one that does not. Source:
/// chapter 7.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "study/ingredients/comparison.hpp"

namespace timestep::study {

/// All of them, in the order of the table. In double but where it is the ingredient.
std::vector<Comparison> ingredients();

/// What both sides of a comparison take, each body and step [ns]: medians of runs in
/// turns, of which `more` is that of the differences. `spread` is half the range that
/// holds the middle half of those. Timed are the first steps alone, as long as what
/// lacks an ingredient goes nearly the same way.
struct Price {
  double with, without, more, spread;
};
Price price_of(const Comparison& comparison, int repeats);

/// A row with its errors and, if there were any repeats, its costs.
nlohmann::ordered_json row_of(const Comparison& comparison, int repeats);

}  // namespace timestep::study
