#include "study/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "study/quantity.hpp"
#include "study/tune_settings.hpp"

namespace timestep::study {
namespace {

using Json = nlohmann::ordered_json;

// Without those that all cells of the problem have
std::string settings_text(const Cell& cell) {
  std::string text;
  for (const auto& [name, value] : cell.settings)
    if (!cell.problem->settings.contains(name))
      text += fmt::format(", {} {}", name, short_text(value));
  return text;
}

std::string wish_text(const Wish& wish, const std::string& unit) {
  if (wish.kind == Wish::Kind::error)
    return "error at most " + quantity_text(wish.value, unit);
  return fmt::format("cost at most {} a frame", quantity_text(wish.value, "us"));
}

std::string error_text(double error, const std::string& unit) {
  return std::isfinite(error) ? quantity_text(error, unit) : "failed";
}

// "dt x 0.97, dt x 1.03, seed = 2 to seed = 9"
std::string names_of(const std::vector<Probe>& probes) {
  constexpr std::size_t k_ends = 3;
  std::string text;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (i >= k_ends && i + 1 < probes.size() && probes.size() > 2 * k_ends) continue;
    text += text.empty() ? "" : i > k_ends ? " to " : ", ";
    text += probes[i].what;
  }
  return text;
}

std::string cost_text(const Trial& trial) {
  const std::string cost = quantity_text(trial.cost, "us");
  if (trial.time.repeats == 0) return cost + ", by the time of another step";
  return fmt::format("{}, the median of {} runs, spread {:.1f} %", cost,
                     trial.time.repeats, 100 * trial.time.spread);
}

// Laplace's rule of succession: where k of n held, the next one fails with a chance of
// (n - k + 1) / (n + 2)
std::string chance_text(std::size_t held, std::size_t all) {
  const double chance =
      static_cast<double>(all - held + 1) / static_cast<double>(all + 2);
  return fmt::format("expect {:.0f} % of other seeds to do worse", 100 * chance);
}

std::string fresh_text(const Outcome& outcome, const Wish& wish,
                       const std::string& unit) {
  const std::size_t all = outcome.fresh.size(), good = held(outcome, wish);
  if (all == 0) return "no time was left for fresh starts";
  std::string text = fmt::format(
      "of {} fresh starts, which had no part in the choice, "
      "{} hold",
      all, good);
  if (good < all) {
    const Probe& worst = *std::ranges::max_element(outcome.fresh, {}, &Probe::error);
    text += fmt::format(" ({} with {})", error_text(worst.error, unit), worst.what);
  }
  if (outcome.fresh.front().what.starts_with("seed"))
    return text + ": " + chance_text(good, all);
  return text + "; farther away nothing is known";
}

std::string trust_text(const Outcome& outcome, const Wish& wish,
                       const std::string& unit) {
  std::string text = "  trust  ";
  if (wish.kind == Wish::Kind::error)
    text += fmt::format("the worst of these is {:.0f} % of what is allowed\n         ",
                        100 * outcome.best.worst / wish.value);
  if (other_starts(outcome.best.cell).empty())
    return text + "no other start was tried: nothing is known but this one\n";
  return text + fresh_text(outcome, wish, unit) + "\n";
}

std::string answer_text(const Trial& best, const std::string& unit) {
  const Cell& cell = best.cell;
  std::string text = fmt::format("  {}, {}, dt {}{}\n", cell.method, cell.precision,
                                 step_text(cell.dt), settings_text(cell));
  text += fmt::format("  error  {}", error_text(best.error, unit));
  if (!best.probes.empty())
    text += fmt::format("; {} at worst with {}", error_text(best.worst, unit),
                        names_of(best.probes));
  text += fmt::format("\n  cost   {}, a frame of {}\n", cost_text(best),
                      step_text(cell.problem->frame));
  return text;
}

std::string verdict(const Wish& wish, const Outcome& outcome) {
  if (outcome.met)
    return wish.kind == Wish::Kind::error ? "The cheapest setting found:"
                                          : "The most accurate setting found:";
  if (wish.kind == Wish::Kind::error)
    return "Nothing tried meets this. The nearest to it:";
  return "Nothing tried is so cheap. The cheapest:";
}

std::string copy_text(const Cell& cell) {
  std::string text = "\nRun it:\n  " + command_of(cell) + "\n\nCopy it:\n";
  for (const std::string& line : code_of(cell)) text += "  " + line + "\n";
  return text;
}

// Where the rows next to the answer in cost begin
std::size_t first_row(const Outcome& outcome, std::size_t rows) {
  const auto dearer =
      std::ranges::upper_bound(outcome.tried, outcome.best.cost, {}, &Trial::cost);
  const auto place = static_cast<std::size_t>(dearer - outcome.tried.begin());
  return std::min(place > rows ? place - rows : 0, outcome.tried.size() - rows);
}

std::string table(const Outcome& outcome, const std::string& unit, std::size_t most) {
  const std::size_t all = outcome.tried.size(), rows = std::min(most, all);
  const std::size_t first = first_row(outcome, rows);
  std::size_t width = 6;
  for (std::size_t i = first; i < first + rows; ++i) {
    const Cell& cell = outcome.tried[i].cell;
    width = std::max(width, cell.method.size() + settings_text(cell).size());
  }

  std::string text = fmt::format("\nTried, the cheapest first ({} to {} of {}",
                                 first + 1, first + rows, all);
  if (outcome.left_out > 0)
    text += fmt::format("; {} left out, since they take too long", outcome.left_out);
  if (outcome.not_reached > 0)
    text += fmt::format("; {} not reached in the time given", outcome.not_reached);
  text += fmt::format("):\n  {:>9}  {:>12}  {:<{}}  {:<9}  {}\n", "cost", "error",
                      "method", width, "precision", "dt");
  for (std::size_t i = first; i < first + rows; ++i) {
    const Trial& trial = outcome.tried[i];
    text += fmt::format("  {:>9}  {:>12}  {:<{}}  {:<9}  {:<10}  {}\n",
                        quantity_text(trial.cost, "us"), error_text(trial.error, unit),
                        trial.cell.method + settings_text(trial.cell), width,
                        trial.cell.precision, step_text(trial.cell.dt),
                        trial.refused.empty() ? "serves" : trial.refused);
  }
  return text;
}

Json number(double value) {
  if (std::isfinite(value)) return value;
  return exact_text(value);
}

Json trial_json(const Trial& trial) {
  Json probes = Json::object();
  for (const Probe& probe : trial.probes) probes[probe.what] = number(probe.error);
  return {{"key", key(trial.cell)},
          {"method", trial.cell.method},
          {"precision", trial.cell.precision},
          {"dt", trial.cell.dt},
          {"settings", trial.cell.settings},
          {"us_per_frame", number(trial.cost)},
          {"spread", trial.time.spread},
          {"repeats", trial.time.repeats},
          {"error", number(trial.error)},
          {"worst", number(trial.worst)},
          {"probes", probes},
          {"refused", trial.refused}};
}

}  // namespace

std::string report(const Problem& problem, const Wish& wish, const Outcome& outcome,
                   const std::string& unit, std::size_t rows) {
  std::string text =
      fmt::format("{}: {} of {}, {}\n  against {}\n\n", problem.name, problem.metric,
                  problem.scene, wish_text(wish, unit), problem.exact);
  text += verdict(wish, outcome) + "\n" + answer_text(outcome.best, unit);
  if (outcome.met)
    text += trust_text(outcome, wish, unit) + copy_text(outcome.best.cell);
  return text + table(outcome, unit, rows);
}

nlohmann::ordered_json report_json(const Problem& problem, const Wish& wish,
                                   const Outcome& outcome, const std::string& unit) {
  const bool by_error = wish.kind == Wish::Kind::error;
  Json tried = Json::array();
  for (const Trial& trial : outcome.tried) tried.push_back(trial_json(trial));
  Json fresh = Json::object();
  for (const Probe& probe : outcome.fresh) fresh[probe.what] = number(probe.error);
  Json best = trial_json(outcome.best);
  best["command"] = command_of(outcome.best.cell);
  best["code"] = code_of(outcome.best.cell);
  return {{"problem", problem.name},
          {"chapter", problem.chapter},
          {"scene", problem.scene},
          {"metric", problem.metric},
          {"unit", unit},
          {"wish", {{by_error ? "error" : "us_per_frame", wish.value}}},
          {"met", outcome.met},
          {"best", best},
          {"fresh", fresh},
          {"held", held(outcome, wish)},
          {"tried", tried},
          {"left_out", outcome.left_out},
          {"not_reached", outcome.not_reached}};
}

}  // namespace timestep::study
