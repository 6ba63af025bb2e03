// Fronts that one sees at a glance, then any runs, by the definition.
#include "chapters/07-trade/exercises/7_1_front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

constexpr Real k_infinite = std::numeric_limits<Real>::infinity();
constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();

// Which runs are on it, in order, in words
std::string in_words(const std::vector<std::size_t>& front) {
  return fmt::format("{}", fmt::join(front, ", "));
}

void expect_front(const char* what, const std::vector<Measured>& runs,
                  const std::vector<std::size_t>& right) {
  const std::vector<std::size_t> yours = pareto_front(runs);
  if (yours == right) return;
  FAIL(fmt::format("{}: yours has the runs {}; right are {}", what, in_words(yours),
                   in_words(right)));
}

bool is_better(const Measured& a, const Measured& b) {
  return a.cost <= b.cost && a.error <= b.error
         && (a.cost < b.cost || a.error < b.error);
}

// By the definition, which takes the square of the time
std::vector<std::size_t> front_of(const std::vector<Measured>& runs) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    bool is_on_it = std::isfinite(runs[i].error);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const bool is_same =
          runs[k].cost == runs[i].cost && runs[k].error == runs[i].error;
      if (is_better(runs[k], runs[i]) || (is_same && k < i)) is_on_it = false;
    }
    if (is_on_it) front.push_back(i);
  }
  std::ranges::sort(front, {}, [&](std::size_t i) { return runs[i].cost; });
  return front;
}

}  // namespace

TEST_CASE("more cost, less error: all are on it") {
  expect_front("three runs", {{4, 0.1}, {1, 0.9}, {2, 0.5}}, {1, 2, 0});
  expect_front("one run", {{1, 1}}, {0});
  expect_front("no run", {}, {});
}

TEST_CASE("who costs more and is worse is not") {
  expect_front("a worse run", {{1, 0.5}, {2, 0.6}, {3, 0.1}}, {0, 2});
  expect_front("one beats all", {{2, 0.5}, {1, 0.1}, {3, 0.2}}, {1});
}

TEST_CASE("equal cost, equal error, equal runs") {
  expect_front("equal cost", {{1, 0.5}, {1, 0.2}}, {1});
  expect_front("equal error", {{2, 0.5}, {1, 0.5}}, {1});
  expect_front("equal runs", {{2, 0.1}, {1, 0.5}, {1, 0.5}}, {1, 0});
}

TEST_CASE("a run that failed is not on it, and pushes nobody off") {
  expect_front("NaN", {{1, k_nan}, {2, 0.5}, {3, k_nan}, {4, 0.1}}, {1, 3});
  expect_front("infinite", {{1, k_infinite}, {2, 0.5}}, {1});
  expect_front("nothing but failures", {{1, k_nan}, {2, k_infinite}}, {});
}

TEST_CASE("any runs") {
  // Few values, so that many are equal; those that failed are worse than all
  Random random(71);
  for (int i = 0; i < 300; ++i) {
    std::vector<Measured> runs;
    for (int k = 0; k < 20; ++k) {
      const Real error = std::floor(random.between(0, 9));
      runs.push_back(
          {std::floor(random.between(0, 8)), error == 8 ? k_infinite : error});
    }
    expect_front("twenty runs", runs, front_of(runs));
  }
}
