// Deals by hand, then any offers, against all numbers of steps there are.
#include "chapters/07-trade/exercises/7_3_budget.hpp"

#include <cmath>
#include <vector>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// A frame of 1/64 s, so that steps and powers of them are exact in these cases
constexpr Real k_frame = 1.0 / 64;
const Offer k_euler{1, 1, 1, 0.5}, k_verlet{1.5, 2, 1, 0.5}, k_rk4{4, 4, 1, 0.5};

void expect_deal(const char* what, const std::vector<Offer>& offers, Real frame,
                 Real error, Real budget, const Deal& right) {
  const Deal yours = best_deal(offers, frame, error, budget);
  expect(fmt::format("steps, {}", what), yours.steps, right.steps, 0);
  if (right.steps > 0)
    expect(fmt::format("index of the offer, {}", what), static_cast<Real>(yours.offer),
           static_cast<Real>(right.offer), 0);
}

Real error_of(const Offer& offer, Real frame, int steps) {
  return offer.constant * std::pow(frame / steps, offer.order);
}

// Every number of steps of every offer that the budget pays for
Deal deal_of(const std::vector<Offer>& offers, Real frame, Real error, Real budget) {
  Deal best;
  Real best_cost = 0, best_error = 0;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const Offer& offer = offers[i];
    for (int steps = 1; steps * offer.cost <= budget; ++steps) {
      const Real cost = steps * offer.cost, its_error = error_of(offer, frame, steps);
      if (frame / steps > offer.longest_step || its_error > error) continue;
      if (best.steps > 0
          && (cost > best_cost || (cost == best_cost && its_error >= best_error)))
        continue;
      best = {i, steps};
      best_cost = cost;
      best_error = its_error;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("nobody looks closely: the cheapest step wins") {
  expect_deal("an error of 1/50", {k_verlet, k_euler, k_rk4}, k_frame, 0.02, 100,
              {1, 1});
}

TEST_CASE("a smaller error, and a higher order pays") {
  // Euler needs 16 steps, Verlet two of half a frame, RK4 one
  expect_deal("an error of 1e-4", {k_euler, k_verlet, k_rk4}, k_frame, 1e-4, 100,
              {1, 2});
  expect_deal("an error of 1e-7", {k_euler, k_verlet, k_rk4}, k_frame, 1e-7, 100,
              {2, 1});
}

TEST_CASE("a step that explodes is not for sale") {
  const Offer stiff{1, 1, 1, k_frame / 3};
  expect_deal("a limit of a third of a frame", {stiff}, k_frame, 1, 100, {0, 3});
}

TEST_CASE("a budget that nobody keeps") {
  expect_deal("2 µs for Verlet's two steps", {k_euler, k_verlet, k_rk4}, k_frame, 1e-4,
              2, {0, 0});
  expect_deal("no offers", {}, k_frame, 1, 100, {0, 0});
}

TEST_CASE("of two that cost the same, the smaller error") {
  const Offer other{1.5, 2, 0.5, 0.5};
  expect_deal("twice the constant, and once", {k_verlet, other}, k_frame, 2.5e-4, 100,
              {1, 1});
  expect_deal("the other way round", {other, k_verlet}, k_frame, 2.5e-4, 100, {0, 1});
}

TEST_CASE("any offers") {
  Random random(73);
  int served = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Offer> offers;
    for (int k = 0; k < 5; ++k)
      offers.push_back({random.log_between(0.5, 10), random.between(1, 4),
                        random.log_between(0.1, 100), random.log_between(1e-3, 1)});
    const Real error = random.log_between(1e-6, 1e-1);
    const Deal right = deal_of(offers, k_frame, error, 200);
    expect_deal("five offers", offers, k_frame, error, 200, right);
    served += right.steps > 0;
  }
  REQUIRE(served > 100);
}
