#include "study/run.hpp"

#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/graphics/input_error.hpp"
#include "study/estimate.hpp"
#include "study/journal.hpp"
#include "study/merge.hpp"

namespace timestep::study {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<Cell> all_cells(const Options& options) {
  return cells(studied_problems(options.names, options.quick), options.quick);
}

std::filesystem::path journal_of(const Options& options) {
  if (options.shards == 1) return options.out / "journal.jsonl";
  return options.out
         / fmt::format("journal-{}-of-{}.jsonl", options.shard, options.shards);
}

/// What a step of a chapter's scenes takes, roughly [s]: the estimate's first guess.
double step_seconds(const Cell& cell) {
  static const std::map<std::string, double> by_chapter{
      {"01-particles", 5e-8}, {"02-verlet", 2e-7},      {"03-rigid-bodies", 5e-7},
      {"04-contacts", 1e-5},  {"05-penetration", 2e-6}, {"06-impulses", 5e-6}};
  constexpr double k_impacts = 100;  // of an iteration of worst_first
  const std::string& chapter = cell.problem->chapter;
  const bool is_costly = chapter == "06-impulses"
                         && (cell.method == "worst_first" || cell.method == "lcp");
  return by_chapter.at(chapter) * (is_costly ? k_impacts : 1);
}

/// Time of the run for a cell's error, roughly [s]: steps, times sweeps or substeps.
double expected_seconds(const Cell& cell) {
  double effort = 1;
  for (const char* name : {"iterations", "substeps"}) {
    const auto found = cell.settings.find(name);
    if (found != cell.settings.end()) effort += 0.2 * found->second;
  }
  return step_seconds(cell) * effort * cell.problem->duration / cell.dt;
}

/// A cell to run for its error, or for its time.
struct Run {
  const Cell* cell = nullptr;
  bool is_timing = false;
};

/// What the journal lacks: first the errors, then the times.
std::vector<Run> missing_runs(const std::vector<Cell>& part, const Journal& journal,
                              bool times) {
  std::vector<Run> errors, timings;
  for (const Cell& cell : part) {
    const Record* record = journal.find(key(cell));
    if (record != nullptr && !belongs_to(*record, cell))
      throw InputError(
          fmt::format("{}: the journal is of another study; choose another "
                      "--out, or remove it",
                      record->key));
    if (record == nullptr) errors.push_back({&cell, false});
    if (times && (record == nullptr || wants_time(*record)))
      timings.push_back({&cell, true});
  }
  errors.insert(errors.end(), timings.begin(), timings.end());
  return errors;
}

std::vector<Task> tasks_of(const std::vector<Run>& runs, int repeats) {
  std::vector<Task> tasks;
  for (const Run& run : runs) {
    const double seconds = expected_seconds(*run.cell);
    if (run.is_timing)
      tasks.push_back({"times", expected_timing(seconds, repeats), true});
    else
      tasks.push_back({run.cell->problem->name + "/" + run.cell->method, seconds});
  }
  return tasks;
}

/// Nothing for the time of a cell that has failed meanwhile.
void compute(const Run& run, Journal& journal, int repeats) {
  const Cell& cell = *run.cell;
  if (!run.is_timing) return journal.append(record_of(cell, measure_error(cell)));
  const Record record = *journal.find(key(cell));
  if (wants_time(record)) journal.append(timed(record, measure_time(cell, repeats)));
}

}  // namespace

std::unique_ptr<Journal> open_journal(const Options& options) {
  auto journal = std::make_unique<Journal>(journal_of(options));
  for (const auto& file : journals_of(std::vector{options.out}))
    journal->know(read_journal(file));
  return journal;
}

void compute(const Options& options, Journal& journal) {
  note_interrupts();
  const std::vector<Cell> all = all_cells(options);
  const std::vector<Cell> part = shard_of(all, options.shard, options.shards);
  const std::vector<Run> runs = missing_runs(part, journal, options.times);
  Estimate estimate(tasks_of(runs, options.repeats));
  ProgressBar bar;
  for (const Run& run : runs) {
    throw_if_interrupted();
    if (options.shows_progress) bar.show(estimate, run.is_timing ? "times" : "errors");
    const auto begin = Clock::now();
    compute(run, journal, options.repeats);
    estimate.finish(std::chrono::duration<double>(Clock::now() - begin).count());
  }
}

void merge_and_write(const Options& options) {
  const bool given = !options.merge.empty();
  const auto places =
      given ? options.merge : std::vector<std::filesystem::path>{options.out};
  const std::vector<Record> records =
      merge(journals_of(places), {.cells = all_cells(options),
                                  .times = options.times,
                                  .partial = options.partial});
  write_tables(records, options.out);
  print_out(fmt::format("{} rows in {}\n", records.size(),
                        (options.out / "study.csv").string()));
}

std::string listing(const Options& options) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  std::string text;
  for (const Problem* problem : studied_problems(options.names, options.quick)) {
    const std::size_t count = cells(std::vector{problem}, options.quick).size();
    text +=
        fmt::format("{:20} {:4} cells: {} of {} {}, from: {}\n", problem->name, count,
                    problem->metric, problem->chapter, problem->scene, problem->exact);
    list.push_back({{"name", problem->name},
                    {"chapter", problem->chapter},
                    {"scene", problem->scene},
                    {"metric", problem->metric},
                    {"known", problem->known},
                    {"exact", problem->exact},
                    {"frame", problem->frame},
                    {"duration", problem->duration},
                    {"dts", problem->dts},
                    {"settings", problem->settings},
                    {"cells", count}});
  }
  if (!options.json) return text;
  return Json{{"compiler", TIMESTEP_COMPILER}, {"problems", list}}.dump(1) + "\n";
}

}  // namespace timestep::study
