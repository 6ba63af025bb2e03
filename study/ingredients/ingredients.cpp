#include "study/ingredients/ingredients.hpp"

#include <algorithm>
#include <array>
#include <ctime>

#include <nlohmann/json.hpp>

#include "study/ingredients/contacts.hpp"
#include "study/ingredients/flight.hpp"
#include "study/quantile.hpp"

namespace timestep::study {
namespace {

constexpr int k_timed_steps = 10;  // both sides go the same way so long

constexpr std::array k_order{"drag",
                             "rotation",
                             "gyroscopic term",
                             "inertia tensor",
                             "friction",
                             "rolling friction",
                             "restitution threshold",
                             "four-point manifold",
                             "warm start",
                             "sub-steps",
                             "double",
                             "EPA"};

auto place_in_table(const Comparison& comparison) {
  return std::pair(std::ranges::find(k_order, comparison.ingredient),
                   !comparison.matters);
}

// A ball that is thrown so far from the origin [m]
Comparison precision(const std::string& scene, bool matters, double from) {
  return {.ingredient = "double",
          .scene = scene,
          .matters = matters,
          .metric = "place",
          .unit = "m",
          .exact = "free fall",
          .steps = 60,
          .bodies = 1024,
          .with = {"double",
                   [=] { return double_precision::ingredients::thrown_ball(from); }},
          .without = {"single", [=] {
                        return single_precision::ingredients::thrown_ball(from);
                      }}};
}

// [ns] of this thread: it does not go on while others have the processor
double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

// [ns] each body and step, of a few steps after the first, of several that start alike
double time_of(const Comparison& comparison, const Model& model) {
  constexpr int k_motions = 8;
  std::vector<Motion> motions;
  for (int i = 0; i < k_motions; ++i) motions.push_back(model.start());
  for (const Motion& motion : motions) motion.step();

  const double start = thread_time();
  for (const Motion& motion : motions)
    for (int i = 0; i < k_timed_steps; ++i) motion.step();
  return (thread_time() - start) / (k_motions * k_timed_steps * comparison.bodies);
}

}  // namespace

std::vector<Comparison> ingredients() {
  namespace of = double_precision::ingredients;
  std::vector<Comparison> all{
      precision("ball thrown 1,000 km from the origin", true, 1e6),
      precision("ball thrown at the origin", false, 0)};
  for (const auto& more : {of::flight_comparisons(), of::surface_comparisons(),
                           of::stack_comparisons(), of::pair_comparisons()})
    all.insert(all.end(), more.begin(), more.end());
  std::ranges::stable_sort(all, {}, place_in_table);
  return all;
}

Price price_of(const Comparison& comparison, int repeats) {
  std::vector<double> with, without, more;
  for (int i = 0; i < repeats; ++i) {
    with.push_back(time_of(comparison, comparison.with));
    without.push_back(time_of(comparison, comparison.without));
    more.push_back(with.back() - without.back());
  }
  return {quantile(with, 0.5), quantile(without, 0.5), quantile(more, 0.5),
          (quantile(more, 0.75) - quantile(more, 0.25)) / 2};
}

nlohmann::ordered_json row_of(const Comparison& comparison, int repeats) {
  nlohmann::ordered_json row{
      {"ingredient", comparison.ingredient},
      {"scene", comparison.scene},
      {"matters", comparison.matters},
      {"with", comparison.with.name},
      {"without", comparison.without.name},
      {"dt", comparison.dt},
      {"steps", comparison.steps},
      {"timed_steps", k_timed_steps},
      {"bodies", comparison.bodies},
      {"metric", comparison.metric},
      {"unit", comparison.unit},
      {"exact", comparison.exact},
      {"error_with", error_of(comparison, comparison.with)},
      {"error_without", error_of(comparison, comparison.without)}};
  if (repeats == 0) return row;
  const Price price = price_of(comparison, repeats);
  row["ns_with"] = price.with;
  row["ns_without"] = price.without;
  row["ns_more"] = price.more;
  row["spread"] = price.spread;
  row["repeats"] = repeats;
  return row;
}

}  // namespace timestep::study
