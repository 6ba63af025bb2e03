// Below, every run that did not fail is on the front, the cheapest first.
//
// Hints: go through the runs from the cheapest to the costliest. A run is worth its
// cost only if its error is below that of all cheaper ones. Mind runs of equal cost:
// which of them should come first? A comparison with NaN is never true.
#include "chapters/07-trade/exercises/7_1_front.hpp"

#include <algorithm>
#include <cmath>

namespace timestep {

std::vector<std::size_t> pareto_front(std::span<const Measured> runs) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (std::isfinite(runs[i].error)) front.push_back(i);
  std::ranges::stable_sort(front, {}, [&](std::size_t i) { return runs[i].cost; });
  return front;
}

}  // namespace timestep
