// Sorted by cost, and by error where that is equal, each run has only to beat the best
// so far: whoever is cheaper has been before it. An infinite error beats nobody, and
// NaN compares as false, so a run that failed needs no word of its own but in the sort,
// which must be spared NaN.
#include "chapters/07-trade/exercises/7_1_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace timestep {

std::vector<std::size_t> pareto_front(std::span<const Measured> runs) {
  std::vector<std::size_t> sorted;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (std::isfinite(runs[i].error)) sorted.push_back(i);
  std::ranges::stable_sort(sorted, {}, [&](std::size_t i) {
    return std::pair(runs[i].cost, runs[i].error);
  });

  std::vector<std::size_t> front;
  Real least = std::numeric_limits<Real>::infinity();
  for (const std::size_t i : sorted) {
    if (!(runs[i].error < least)) continue;
    least = runs[i].error;
    front.push_back(i);
  }
  return front;
}

}  // namespace timestep
