#include "study/tune.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::study {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Cells that differ in their step alone, the longest first.
struct Family {
  std::vector<Cell> ladder;
  double cost_of_second = k_infinity;  ///< [us s] cost times step
  std::size_t tried = 0;               ///< so many of the ladder, all refused
  double last_error = k_infinity;      ///< of the last one tried
};

/// A search on its way.
struct Search {
  Wish wish;
  Meter meter;
  Patience patience;
  std::function<void(double)> progress;
  std::vector<Family> families;
  Outcome outcome;

  double cost(const Family& family, double dt) const {
    return family.cost_of_second / dt;
  }
};

// Three digits are enough for a step that is found by trying
double rounded(double dt) {
  return std::strtod(fmt::format("{:.3g}", dt).c_str(), nullptr);
}

// The study's shortest step need not be the shortest that is worth its price
void extend(std::vector<Cell>& ladder) {
  constexpr int k_more = 5;
  for (int i = 0; i < k_more; ++i) {
    ladder.push_back(ladder.back());
    ladder.back().dt /= 2;
  }
}

std::vector<Family> families_of(const std::vector<Cell>& cells) {
  std::map<std::string, std::size_t> places;
  std::vector<Family> families;
  for (const Cell& cell : cells) {
    Cell without_step = cell;
    without_step.dt = 0;
    const auto [place, is_new] = places.try_emplace(key(without_step), families.size());
    if (is_new) families.emplace_back();
    families[place->second].ladder.push_back(cell);
  }
  for (Family& family : families) {
    std::ranges::sort(family.ladder, std::greater{}, &Cell::dt);
    if (family.ladder.size() > 1) extend(family.ladder);
  }
  return families;
}

// At the third step, or where that fails at a shorter one; false if all fail, or time
// is over
bool take_time(Search& search, Family& family) {
  if (search.patience.is_over()) {
    search.outcome.not_reached += family.ladder.size();
    return false;
  }
  const std::size_t last = family.ladder.size() - 1;
  for (std::size_t i = std::min<std::size_t>(2, last); i <= last; ++i) {
    const double cost = search.meter.time(family.ladder[i]).us_per_frame;
    if (!(cost > 0 && std::isfinite(cost))) continue;
    family.cost_of_second = cost * family.ladder[i].dt;
    return true;
  }
  Trial trial;
  trial.cell = family.ladder.front();
  trial.cost = k_infinity;
  trial.refused = "no step of it can be taken";
  search.outcome.tried.push_back(trial);
  return false;
}

// The size of an error; infinite for a run that failed
double size_of(const ErrorResult& result) {
  const double size = std::abs(result.error);
  return result.failed.empty() && std::isfinite(size) ? size : k_infinity;
}

// Takes the probes one by one while the error stays below `limit`
void take_probes(const Search& search, Trial& trial, double limit) {
  std::vector<Probe> probes = neighbours(trial.cell);
  for (Probe& probe : other_starts(trial.cell)) probes.push_back(std::move(probe));
  for (Probe& probe : probes) {
    if (trial.worst > limit) return;
    probe.error = size_of(search.meter.error(probe.cell));
    trial.worst = std::max(trial.worst, probe.error);
    trial.probes.push_back(std::move(probe));
  }
}

std::string refusal(const Trial& trial, const ErrorResult& result, double limit) {
  if (!result.failed.empty()) return result.failed;
  if (trial.error > limit) return "error too large";
  if (trial.worst > limit)
    return fmt::format("{} gives {}", trial.probes.back().what,
                       short_text(trial.worst));
  return "";
}

// One step of one setting: whether its error stays below the limit, probes included
Trial look(const Search& search, const Family& family, double dt, double limit) {
  Trial trial;
  trial.cell = family.ladder.front();
  trial.cell.dt = dt;
  trial.cost = search.cost(family, dt);
  const ErrorResult result = search.meter.error(trial.cell);
  trial.error = trial.worst = size_of(result);
  if (trial.error <= limit) take_probes(search, trial, limit);
  trial.refused = refusal(trial, result, limit);
  return trial;
}

bool takes_too_long(const Search& search, const Cell& cell, double cost) {
  const double seconds = cost * 1e-6 * cell.problem->duration / cell.problem->frame;
  return seconds > search.patience.longest_run;
}

// What cannot be stepped at all is no trial: its cost is infinite
void throw_if_nothing_tried(const Outcome& outcome) {
  const auto is_trial = [](const Trial& trial) { return std::isfinite(trial.cost); };
  const bool is_short = outcome.left_out + outcome.not_reached > 0;
  if (is_short && std::ranges::none_of(outcome.tried, is_trial))
    throw InputError("--seconds is too short to try any setting");
}

// Halves the way, in the logarithm, from a step that serves to one that does not
void lengthen(Search& search, const Family& family, double good, double bad) {
  constexpr int k_halvings = 4;
  for (int i = 0; i < k_halvings; ++i) {
    const double dt = rounded(std::sqrt(good * bad));
    if (dt <= good || dt >= bad || search.patience.is_over()) return;
    const Trial trial = look(search, family, dt, search.wish.value);
    search.outcome.tried.push_back(trial);
    if (trial.refused.empty()) search.outcome.best = trial;
    (trial.refused.empty() ? good : bad) = dt;
  }
}

/// A cell of a family's ladder.
struct Rung {
  std::size_t family, place;
  double cost;
};

std::vector<Rung> rungs_by_cost(const Search& search) {
  std::vector<Rung> rungs;
  for (std::size_t f = 0; f < search.families.size(); ++f)
    for (std::size_t i = 0; i < search.families[f].ladder.size(); ++i) {
      const Family& family = search.families[f];
      rungs.push_back({f, i, search.cost(family, family.ladder[i].dt)});
    }
  std::ranges::stable_sort(rungs, {}, &Rung::cost);
  return rungs;
}

// From the cheapest cell on to the first that serves; its family, or null
Family* first_that_serves(Search& search) {
  const std::vector<Rung> rungs = rungs_by_cost(search);
  for (std::size_t done = 0; done < rungs.size(); ++done) {
    const Rung& rung = rungs[done];
    Family& family = search.families[rung.family];
    const Cell& cell = family.ladder[rung.place];
    search.progress(static_cast<double>(done) / static_cast<double>(rungs.size()));
    if (search.patience.is_over()) {
      search.outcome.not_reached += rungs.size() - done;
      return nullptr;
    }
    if (takes_too_long(search, cell, rung.cost)) {
      ++search.outcome.left_out;
      continue;
    }
    const Trial trial = look(search, family, cell.dt, search.wish.value);
    search.outcome.tried.push_back(trial);
    if (trial.refused.empty()) {
      search.outcome.best = trial;
      return &family;
    }
    family.tried = rung.place + 1;
    family.last_error = trial.error;
  }
  return nullptr;
}

// Whether a step shorter than the last one tried may serve: an error that shrinks
// faster than the eighth power of the step is nothing to hope for. What failed may do
// anything.
bool may_serve(const Search& search, const Family& family, double dt) {
  constexpr double k_order = 8;
  const double ratio = dt / family.ladder[family.tried - 1].dt;
  return !std::isfinite(family.last_error)
         || family.last_error * std::pow(ratio, k_order) <= search.wish.value;
}

// Another setting whose cells straddle the best cost: is there a step between them that
// serves and is a tenth cheaper?
void challenge(Search& search, const Family& family) {
  constexpr double k_cheaper = 0.9;
  if (family.tried == 0 || search.patience.is_over()) return;
  const double longer = family.ladder[family.tried - 1].dt;
  const double dt =
      rounded(family.cost_of_second / (k_cheaper * search.outcome.best.cost));
  if (dt >= longer || family.tried == family.ladder.size()) return;
  if (dt < family.ladder[family.tried].dt || !may_serve(search, family, dt)) return;
  const Trial trial = look(search, family, dt, search.wish.value);
  search.outcome.tried.push_back(trial);
  if (!trial.refused.empty()) return;
  search.outcome.best = trial;
  lengthen(search, family, dt, longer);
}

// The wish's own number: how far a trial is from it
double distance_of(const Search& search, const Trial& trial) {
  return search.wish.kind == Wish::Kind::error ? trial.worst : trial.cost;
}

// What came nearest, where nothing serves
void take_nearest(Search& search) {
  double nearest = k_infinity;
  for (const Trial& trial : search.outcome.tried) {
    const double distance = distance_of(search, trial);
    if (search.outcome.best.cell.problem != nullptr && !(distance < nearest)) continue;
    nearest = distance;
    search.outcome.best = trial;
  }
}

// The one that serves at the least cost, or null
Trial* cheapest(std::vector<Trial>& trials) {
  Trial* best = nullptr;
  for (Trial& trial : trials)
    if (trial.refused.empty() && (best == nullptr || trial.cost < best->cost))
      best = &trial;
  return best;
}

// Costs taken from another step may be wrong: the cheapest is timed itself, until one
// that was timed is the cheapest
void take_times_of_best(Search& search) {
  Trial* best = cheapest(search.outcome.tried);
  while (best->time.repeats == 0) {
    best->time = search.meter.time(best->cell);
    best->cost = best->time.us_per_frame;
    best = cheapest(search.outcome.tried);
  }
  search.outcome.best = *best;
}

void find_cheapest(Search& search) {
  const Family* first = first_that_serves(search);
  if (first == nullptr) {
    throw_if_nothing_tried(search.outcome);
    return take_nearest(search);
  }
  search.outcome.met = true;
  if (first->tried > 0)
    lengthen(search, *first, search.outcome.best.cell.dt,
             first->ladder[first->tried - 1].dt);
  for (const Family& family : search.families)
    if (&family != first) challenge(search, family);
  take_times_of_best(search);
}

// Steps of a family within the budget: the shortest affordable one, and the cells' own
// next two
std::vector<double> affordable_steps(const Search& search, const Family& family) {
  constexpr double k_margin = 0.95;
  constexpr std::size_t k_most = 3;
  const double least = family.cost_of_second / (k_margin * search.wish.value);
  std::vector<double> steps;
  for (const Cell& cell : family.ladder)
    if (cell.dt >= least) steps.push_back(cell.dt);
  const bool has_shorter = steps.size() < family.ladder.size();
  if (has_shorter && !steps.empty() && rounded(least) < steps.back())
    steps.push_back(rounded(least));
  std::ranges::reverse(steps);
  if (steps.size() > k_most) steps.resize(k_most);
  return steps;
}

void try_affordable(Search& search, const Family& family) {
  for (const double dt : affordable_steps(search, family)) {
    if (search.patience.is_over()) {
      ++search.outcome.not_reached;
      continue;
    }
    if (takes_too_long(search, family.ladder.front(), search.cost(family, dt))) {
      ++search.outcome.left_out;
      continue;
    }
    search.outcome.tried.push_back(look(search, family, dt, -1));
    Trial& trial = search.outcome.tried.back();
    if (std::isfinite(trial.error)) trial.refused.clear();
  }
}

// The next best trial, by the error at its own step, that is not refused
Trial* next_best(std::vector<Trial>& trials, double below) {
  Trial* best = nullptr;
  for (Trial& trial : trials)
    if (trial.refused.empty() && trial.error < below
        && (best == nullptr || trial.error < best->error))
      best = &trial;
  return best;
}

// What a budget that nothing keeps is told
void take_cheapest(Search& search) {
  throw_if_nothing_tried(search.outcome);
  const std::vector<Rung> rungs = rungs_by_cost(search);
  if (rungs.empty()) return take_nearest(search);
  const Family& family = search.families[rungs.front().family];
  Trial trial = look(search, family, family.ladder[rungs.front().place].dt, -1);
  trial.time = search.meter.time(trial.cell);
  trial.refused = "dearer than the budget";
  search.outcome.best = trial;
  search.outcome.tried.push_back(trial);
}

// Probes make an error worse, never better: once the next one's own error is above the
// least worst, nothing is left to hope for
void find_most_accurate(Search& search) {
  Outcome& outcome = search.outcome;
  for (std::size_t f = 0; f < search.families.size(); ++f) {
    search.progress(static_cast<double>(f)
                    / static_cast<double>(search.families.size()));
    try_affordable(search, search.families[f]);
  }
  double least = k_infinity;
  while (Trial* trial = next_best(outcome.tried, least)) {
    take_probes(search, *trial, least);
    trial->time = search.meter.time(trial->cell);
    trial->cost = trial->time.us_per_frame;
    if (trial->cost > search.wish.value) {
      trial->refused = "dearer than the budget";
    } else if (trial->worst >= least) {
      trial->refused = "less accurate, with its probes";
    } else {
      least = trial->worst;
      outcome.best = *trial;
      outcome.met = true;
      trial->refused = "less accurate";
    }
  }
  for (Trial& trial : outcome.tried)
    if (trial.refused.empty()) trial.refused = "less accurate";
  if (!outcome.met) take_cheapest(search);
}

// What a choice was made by says too much good of it: starts that had no part in it
void take_fresh_starts(Search& search) {
  for (Probe& probe : fresh_starts(search.outcome.best.cell)) {
    if (search.patience.is_over()) return;
    probe.error = size_of(search.meter.error(probe.cell));
    search.outcome.fresh.push_back(std::move(probe));
  }
}

}  // namespace

Outcome tune(const std::vector<Cell>& cells, const Wish& wish, const Meter& meter,
             const Patience& patience, const std::function<void(double)>& progress) {
  Search search{.wish = wish,
                .meter = meter,
                .patience = patience,
                .progress = progress,
                .families = families_of(cells),
                .outcome = {}};
  std::erase_if(search.families,
                [&](Family& family) { return !take_time(search, family); });
  if (wish.kind == Wish::Kind::error)
    find_cheapest(search);
  else
    find_most_accurate(search);
  if (search.outcome.met) take_fresh_starts(search);
  std::ranges::stable_sort(search.outcome.tried, {}, &Trial::cost);
  return search.outcome;
}

std::size_t held(const Outcome& outcome, const Wish& wish) {
  const double limit = wish.kind == Wish::Kind::error ? wish.value : outcome.best.worst;
  return static_cast<std::size_t>(std::ranges::count_if(
      outcome.fresh, [&](const Probe& probe) { return probe.error <= limit; }));
}

}  // namespace timestep::study
