#include "study/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::study {

std::vector<const Record*> front(std::span<const Record* const> records, Cost cost,
                                 double frame) {
  const auto cost_of = [&](const Record* record) {
    return cost == Cost::time ? record->us_per_frame
                              : evaluations_per_frame(*record, frame);
  };
  std::vector<const Record*> sorted;
  for (const Record* record : records)
    if (record->failed.empty() && std::isfinite(record->error)
        && std::isfinite(cost_of(record)))
      sorted.push_back(record);
  std::ranges::stable_sort(sorted, [&](const Record* a, const Record* b) {
    const double cost_a = cost_of(a), cost_b = cost_of(b);
    return cost_a != cost_b ? cost_a < cost_b : a->error < b->error;
  });

  // From the cheapest on, whoever errs less than all before
  std::vector<const Record*> kept;
  double least = std::numeric_limits<double>::infinity();
  for (const Record* record : sorted) {
    if (record->error >= least) continue;
    least = record->error;
    kept.push_back(record);
  }
  return kept;
}

}  // namespace timestep::study
