// The error fixes the step, the frame and the step fix how many there are, and that
// many times the price of one is what counts. A dear step of a high order is cheap if
// few are needed; a cheap one of first order is cheap as long as nobody looks closely.
#include "chapters/07-trade/exercises/7_3_budget.hpp"

#include <algorithm>
#include <cmath>

namespace timestep {
namespace {

// Of all steps that serve, the fewest. As a Real: there may be more than an int holds
Real steps_needed(const Offer& offer, Real frame, Real error) {
  const Real accurate = std::pow(error / offer.constant, 1 / offer.order);
  return std::max(Real(1), std::ceil(frame / std::min(accurate, offer.longest_step)));
}

}  // namespace

Deal best_deal(std::span<const Offer> offers, Real frame, Real error, Real budget) {
  Deal best;
  Real best_cost = budget, best_error = error;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const Offer& offer = offers[i];
    const Real steps = steps_needed(offer, frame, error), cost = steps * offer.cost;
    const Real its_error = offer.constant * std::pow(frame / steps, offer.order);
    const bool is_first = best.steps == 0 && cost <= best_cost;
    const bool is_better =
        cost < best_cost || (cost == best_cost && its_error < best_error);
    if (!is_first && !is_better) continue;
    best = {i, static_cast<int>(steps)};
    best_cost = cost;
    best_error = its_error;
  }
  return best;
}

}  // namespace timestep
