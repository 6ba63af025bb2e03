// Every case of the truth files, in both precisions, through the same function as
// bin/truth.
#include <set>

#include <fmt/format.h>

#include "tests/catch.hpp"
#include "tests/truth/runner.hpp"

using namespace timestep::truth;

namespace {

const std::filesystem::path k_folder = TIMESTEP_TRUTH;

void check(Precision precision) {
  const Report report = run_cases({k_folder / "truth_public.json"}, "", precision);
  for (const Outcome& outcome : report.outcomes) {
    INFO(outcome.id << ": " << outcome.failure);
    CHECK(outcome.pass);
    CHECK(outcome.fields_not_computed == 0);
  }
}

}  // namespace

TEST_CASE("truth files pass in double") {
  check(Precision::double_bits);
}

TEST_CASE("truth files pass in single with derived tolerances") {
  check(Precision::single_bits);
}

// A kind that is covered must not fall back to "not covered" unnoticed.
TEST_CASE("the kinds of chapter 1 are covered") {
  const Report report =
      run_cases({k_folder / "truth_public.json"}, "", Precision::double_bits);
  std::set<std::string> covered;
  for (const auto& [kind, tally] : report.kinds)
    if (tally.passed > 0) covered.insert(kind);
  for (const char* kind : {"constant_acceleration_steps", "linear_drag_projectile",
                           "quadratic_drag_fall", "oscillator_steps", "growth_factor",
                           "time_accumulation", "float_spacing", "free_fall_float32"}) {
    INFO(kind);
    CHECK(covered.contains(kind));
  }
}
