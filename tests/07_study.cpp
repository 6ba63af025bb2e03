// The study's own parts: what it measures is what the chapters measure, what it writes
// down is never lost or doubled, and shards merge into the same bytes.
#include <cmath>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "common/chapter/numbers.hpp"
#include "common/chapter/runner.hpp"
#include "common/graphics/input_error.hpp"
#include "study/chapters.hpp"
#include "study/estimate.hpp"
#include "study/front.hpp"
#include "study/journal.hpp"
#include "study/merge.hpp"
#include "study/options.hpp"
#include "study/quantile.hpp"
#include "tests/catch.hpp"

using namespace timestep;
using namespace timestep::study;

namespace fs = std::filesystem;

namespace {

/// A folder of the test's own, gone with it.
struct Scratch {
  fs::path folder = fs::temp_directory_path() / fmt::format("study-test-{}", getpid());
  Scratch() { fs::create_directories(folder); }
  ~Scratch() { fs::remove_all(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

std::vector<Cell> cells_of(const std::string& name, bool quick = false) {
  return cells(chosen_problems(std::vector{name}), quick);
}

Record sample(const std::string& key, double error) {
  return {.key = key,
          .problem = "orbit",
          .chapter = "02-verlet",
          .scene = "orbit",
          .metric = "position_error_max",
          .frame = 0.5,
          .duration = 10,
          .method = "rk4",
          .precision = "double",
          .dt = 0.25,
          .settings = {},
          .error = error,
          .unit = "m",
          .failed = {}};
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string words_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void check_says(const std::function<void()>& action, const std::string& part) {
  const std::string words = words_of(action);
  INFO(words);
  CHECK(words.find(part) != std::string::npos);
  CHECK(words.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("every problem names a scene, a metric, methods and settings that exist") {
  std::set<std::string> names, keys;
  for (const Problem& problem : problems()) {
    INFO(problem.name);
    CHECK(names.insert(problem.name).second);
    const std::vector<Cell> own = cells_of(problem.name);
    REQUIRE_FALSE(own.empty());
    for (const Cell& cell : own) {
      CHECK_NOTHROW(plan_of(cell));
      keys.insert(key(cell));
    }
    const Plan plan = plan_of(own.front());
    const std::vector<Lane> lanes = start_lanes(plan);
    std::set<std::string> metrics;
    for (const Metric& metric : lanes.front().simulation->metrics())
      metrics.insert(metric.name);
    CHECK(metrics.contains(problem.metric));
    CHECK((problem.known.empty() || metrics.contains(problem.known)));
  }
  CHECK(keys.size() == cells(chosen_problems({}), false).size());
}

namespace {

/// The cells at a problem's longest step in double, one a method and setting.
std::vector<Cell> coarsest_cells(const Problem& problem) {
  std::vector<Cell> kept;
  for (const Cell& cell : cells(std::vector{&problem}, false))
    if (cell.precision == "double" && cell.dt == problem.dts.front())
      kept.push_back(cell);
  return kept;
}

}  // namespace

TEST_CASE("what is varied makes a difference: no axis for methods that ignore it") {
  for (const Problem& problem : problems()) {
    for (const Axis& axis : problem.axes) {
      CHECK(axis.values.size() > 1);
      // For each method: what comes out at the axis' ends, all else alike
      std::map<std::string, std::set<std::string>> outcomes;
      for (Cell cell : coarsest_cells(problem)) {
        const auto own = cell.settings.find(axis.parameter);
        if (own == cell.settings.end()) continue;
        if (!axis.methods.empty() && !std::ranges::count(axis.methods, cell.method))
          continue;
        if (own->second != axis.values.front() && own->second != axis.values.back())
          continue;
        const ErrorResult result = measure_error(cell);
        cell.settings.erase(own);
        outcomes[key(cell)].insert(fmt::format("{} {} {}", exact_text(result.error),
                                               result.evaluations, result.failed));
      }
      REQUIRE_FALSE(outcomes.empty());
      for (const auto& [rest, found] : outcomes) {
        INFO(rest << " ignores " << axis.parameter);
        CHECK(found.size() == 2);
      }
    }
  }
  for (const Cell& cell : cells_of("stack"))
    CHECK(cell.settings.size() == 1);  // iterations or substeps, never both
}

TEST_CASE("a key names all that identifies a cell, and nothing that a problem fixes") {
  const Problem* stack = chosen_problems(std::vector<std::string>{"pile"}).front();
  Cell cell{stack, "substeps", "single", 0.0625, stack->settings};
  CHECK(key(cell) == "pile/substeps/single/dt=0.0625");
  cell.settings["substeps"] = 8;
  CHECK(key(cell) == "pile/substeps/single/dt=0.0625/substeps=8");
  cell.settings["n"] = 31;
  CHECK(key(cell) == "pile/substeps/single/dt=0.0625/n=31/substeps=8");
}

TEST_CASE("cells come in the same order at each call, and shards part them") {
  const std::vector<Cell> all = cells_of("orbit"), again = cells_of("orbit");
  REQUIRE(all.size() == again.size());
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(key(all[i]) == key(again[i]));

  std::set<std::string> seen;
  std::size_t count = 0;
  for (int shard = 1; shard <= 7; ++shard) {
    for (const Cell& cell : shard_of(all, shard, 7)) seen.insert(key(cell));
    count += shard_of(all, shard, 7).size();
  }
  CHECK(count == all.size());
  CHECK(seen.size() == all.size());
  CHECK(key(shard_of(all, 3, 7).at(1)) == key(all.at(9)));
}

TEST_CASE("the quick study is a part of the whole") {
  std::set<std::string> whole;
  for (const Cell& cell : cells(chosen_problems({}), false)) whole.insert(key(cell));
  const std::vector<Cell> quick = cells(studied_problems({}, true), true);
  CHECK(quick.size() * 4 < whole.size());
  for (const Cell& cell : quick) CHECK(whole.contains(key(cell)));
  const std::vector<std::string> named{"clock"};  // which is not in it
  CHECK(studied_problems(named, true) == chosen_problems(named));
}

TEST_CASE("an unknown problem is answered with the nearest names") {
  const std::vector<std::string> wrong{"orbitt"};
  check_says([&] { chosen_problems(wrong); }, "did you mean orbit?");
  CHECK(chosen_problems(std::vector<std::string>{"sweep"}).size() == 5);
}

TEST_CASE("an error is the number that the chapter itself prints") {
  for (const char* name :
       {"projectile", "orbit", "cue-strike", "sweep-boxes", "corner", "bounce"}) {
    const Cell cell = cells_of(name).front();
    const Plan plan = plan_of(cell);
    std::vector<Lane> lanes = start_lanes(plan);
    run_lanes(plan, lanes, {}, [](double) {});
    const ErrorResult result = measure_error(cell);
    INFO(key(cell));
    REQUIRE(result.failed.empty());
    for (const Metric& metric : lanes.front().metrics) {
      if (metric.name != cell.problem->metric) continue;
      CHECK(result.error == std::abs(metric.value));
      CHECK(result.unit == metric.unit);
    }
    CHECK(result.evaluations == lanes.front().simulation->evaluations());
    CHECK(result.steps == plan.steps);
    CHECK(measure_error(cell).error == result.error);
  }
}

TEST_CASE("a run that fails is a result, with words and without a time") {
  Cell cell = cells_of("sweep-boxes").front();
  cell.method = "closed_form";  // which has no form for two boxes
  const ErrorResult result = measure_error(cell);
  CHECK(std::isnan(result.error));
  CHECK(result.failed.find("no solution for box and box") != std::string::npos);
  CHECK(result.steps == 0);
  const TimeResult time = measure_time(cell);
  CHECK(std::isnan(time.us_per_frame));
  CHECK(time.repeats == 0);
}

TEST_CASE("steps are the same whether or not somebody looks on: times are of the run") {
  for (const char* name : {"orbit", "cue-strike", "two-blocks", "rope", "corner"}) {
    const Plan plan = plan_of(cells_of(name).front());
    std::vector<Lane> lanes = start_lanes(plan);
    advance_lanes(plan, lanes, plan.steps);
    const auto unseen = plan.scene->start(plan.setups.front());
    for (long long i = 0; i < plan.steps; ++i) unseen->step();
    unseen->observe();  // only now
    INFO(name);
    const std::vector<BodyState> a = lanes.front().simulation->bodies();
    const std::vector<BodyState> b = unseen->bodies();
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].position == b[i].position);
  }
}

TEST_CASE("a time is of as many runs as asked for, and grows with the steps") {
  std::vector<Cell> all = cells_of("orbit");
  const TimeResult coarse = measure_time(all.front());
  CHECK(coarse.repeats >= 3);
  CHECK(coarse.us_per_frame > 0);
  CHECK(coarse.spread >= 0);
  // 128 times the steps in a frame; a tenth of that allows for a busy machine
  Cell fine = all.front();
  fine.dt /= 128;
  CHECK(measure_time(fine).us_per_frame > 12 * coarse.us_per_frame);
}

TEST_CASE("runs that take now long, now short are timed five times as often") {
  const auto wait = [](int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  };
  int runs = 0;
  const auto start = [&] {
    return [&, own = runs++](long long) { wait(own % 2 == 0 ? 6 : 12); };
  };
  const TimeResult time = time_of(start, {.steps = 1, .least_repeats = 4});
  CHECK(time.repeats == 20);
  CHECK(time.spread > 0.1);
}

TEST_CASE("a quantile lies between the values, where there are as many below it") {
  CHECK(quantile({4, 1, 3, 2}, 0.5) == 2.5);
  CHECK(quantile({5, 1, 2, 4, 3}, 0.75) == 4);
  CHECK(quantile({7}, 0.25) == 7);
}

TEST_CASE("a record reads back from its line bit for bit") {
  Record record = sample("a \"key\"/µ", 0.1 + 0.2);
  record.settings = {{"iterations", 10}, {"tolerance", 1e-300}};
  record.failed = "at 0.1 s: x is nan, and then";
  CHECK(same_but_time(from_line(to_line(record)), record));
  CHECK(to_line(from_line(to_line(record))) == to_line(record));
  for (const double odd : {k_not_measured, std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), -0.0, 5e-324}) {
    record.error = odd;
    CHECK(same_but_time(from_line(to_line(record)), record));
  }
  CHECK_FALSE(from_line(to_line(record)).peer);
  record.peer = true;
  CHECK(from_line(to_line(record)).peer);
}

TEST_CASE("a journal keeps whole lines, cuts off a torn one, and goes on behind") {
  const Scratch scratch;
  const fs::path file = scratch.folder / "new/journal.jsonl";
  {
    Journal journal(file);
    journal.append(sample("one", 1));
    journal.append(sample("two", 2));
  }
  const std::string whole = read_text(file);
  for (const std::size_t torn : {std::size_t(1), whole.size() / 4}) {
    write_text(file, whole + whole.substr(0, torn));
    Journal journal(file);
    CHECK(read_text(file) == whole);
    REQUIRE(journal.find("two") != nullptr);
    CHECK(journal.find("two")->error == 2);
    CHECK(journal.find("three") == nullptr);
  }
  Journal(file).append(sample("three", 3));
  CHECK(read_journal(file).size() == 3);
}

TEST_CASE(
    "a journal is one process's alone, and must be a journal that can be written") {
  const Scratch scratch;
  const fs::path file = scratch.folder / "journal.jsonl";
  {
    const Journal journal(file);
    check_says([&] { Journal second(file); }, "another study is writing to it");
  }
  CHECK_NOTHROW(Journal(file));
  check_says([&] { Journal folder(scratch.folder); }, "cannot be written");
  write_text(scratch.folder / "file", "");
  check_says([&] { Journal below(scratch.folder / "file/journal.jsonl"); },
             "cannot be written");
  write_text(file, to_line(sample("one", 1)) + "\n{\"key\": 3}\n");
  check_says([&] { Journal wrong(file); }, "line 2 is no record of the study");
  CHECK(read_journal("/dev/null").empty());
  check_says([&] { read_journal(scratch.folder / "none.jsonl"); }, "cannot be read");
}

namespace {

/// A record for each of some cells, with an error that depends on the cell alone.
std::vector<Record> invented(const std::vector<Cell>& some) {
  std::vector<Record> records;
  for (const Cell& cell : some)
    records.push_back(record_of(
        cell, {.error = 1 / cell.dt, .unit = "m", .steps = plan_of(cell).steps}));
  return records;
}

void fill(const fs::path& file, const std::vector<Record>& records) {
  Journal journal(file);
  for (const Record& record : records) journal.append(record);
}

}  // namespace

TEST_CASE("shards merge into the same bytes as one run, in whatever order") {
  const Scratch scratch;
  const std::vector<Cell> all = cells_of("projectile", true);
  const Wanted wanted{.cells = all, .times = false};
  fill(scratch.folder / "one.jsonl", invented(all));
  const auto merged = [&](std::vector<fs::path> files) {
    const std::vector<Record> records = merge(files, wanted);
    return csv_text(records) + json_text(records);
  };
  const std::string expected = merged({scratch.folder / "one.jsonl"});
  std::vector<fs::path> files;
  for (int shard = 3; shard >= 1; --shard) {
    files.push_back(scratch.folder / fmt::format("part-{}.jsonl", shard));
    fill(files.back(), invented(shard_of(all, shard, 3)));
  }
  CHECK(merged(files) == expected);
  files.push_back(scratch.folder / "one.jsonl");  // every key twice, alike
  CHECK(merged(files) == expected);
}

TEST_CASE("a merge refuses what is missing, and what contradicts itself") {
  const Scratch scratch;
  const std::vector<Cell> all = cells_of("projectile", true);
  std::vector<Record> records = invented(all);
  const std::string last = records.back().key;
  records.pop_back();
  const std::vector<fs::path> files{scratch.folder / "a.jsonl",
                                    scratch.folder / "b.jsonl"};
  fill(files[0], records);
  fill(files[1], {records.front()});
  Wanted wanted{.cells = all, .times = false};
  check_says([&] { merge(files, wanted); }, "the first is " + last);
  wanted.partial = true;
  CHECK(merge(files, wanted).size() == all.size() - 1);
  check_says([&] { merge(std::vector<fs::path>{"/dev/null"}, wanted); },
             "no journal has a record");
  wanted = {.cells = {all.front()}, .times = true};
  check_says([&] { merge(files, wanted); }, "or their times");

  records.front().error = std::nextafter(records.front().error, 0.0);
  fill(files[1], {records.front()});
  check_says([&] { merge(files, wanted); }, "disagree");
  check_says([&] { journals_of(std::vector{scratch.folder / "none"}); }, "neither");
  fs::create_directory(scratch.folder / "empty");
  check_says([&] { journals_of(std::vector{scratch.folder / "empty"}); }, "no journal");
}

TEST_CASE("a time that was taken stays, and peers stand behind their problem") {
  const Scratch scratch;
  const std::vector<Cell> all = cells_of("projectile", true);
  std::vector<Record> records = invented(all);
  for (Record& record : records) record = timed(record, {2.5, 7, 0.1});
  Record peer = records.front();
  peer.key = "projectile/zz";
  peer.peer = true;
  records.insert(records.begin(), peer);
  const std::vector<fs::path> files{scratch.folder / "a.jsonl",
                                    scratch.folder / "b.jsonl"};
  fill(files[0], invented(all));
  fill(files[1], records);
  const std::vector<Record> merged = merge(files, {.cells = all});
  REQUIRE(merged.size() == all.size() + 1);
  CHECK(merged.back().peer);
  for (const Record& record : merged) CHECK(record.repeats == 7);
}

TEST_CASE("a record of another metric, duration or number of steps does not belong") {
  const Cell cell = cells_of("projectile").front();
  const Record own = invented({cell}).front();
  CHECK(belongs_to(own, cell));
  Record other = own;
  other.metric = "energy_error_max";
  CHECK_FALSE(belongs_to(other, cell));
  other = own;
  other.duration *= 2;
  CHECK_FALSE(belongs_to(other, cell));
  other = own;
  --other.steps;
  CHECK_FALSE(belongs_to(other, cell));
  other.failed = "at 1 s: it fell";
  CHECK(belongs_to(other, cell));
}

TEST_CASE("what cannot be is no record") {
  for (const auto& [was, is] : {std::pair{R"("dt":0.25)", R"("dt":0.0)"},
                                std::pair{R"("dt":0.25)", R"("dt":"nan")"},
                                std::pair{R"("repeats":0)", R"("repeats":-1)"}}) {
    std::string line = to_line(sample("k", 1));
    line.replace(line.find(was), std::string(was).size(), is);
    INFO(line);
    CHECK_THROWS(from_line(line));
  }
}

TEST_CASE("a table says what the error is, behind the scene") {
  const std::string text = csv_text(std::vector{sample("k", 1)});
  CHECK(text.starts_with("key,problem,chapter,scene,metric,frame,method,"));
  CHECK(text.find("\nk,orbit,02-verlet,orbit,position_error_max,0.5,rk4,")
        != std::string::npos);
}

TEST_CASE("words with commas and quotes stay in their column") {
  Record record = sample("k", 1);
  record.failed = "at 1 s: a, \"b\"";
  const std::string text = csv_text(std::vector{record});
  CHECK(text.find(",\"at 1 s: a, \"\"b\"\"\",false,nan,nan,0\n") != std::string::npos);
}

TEST_CASE("the front is what brute force finds, among points of which many are equal") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> digit(0, 9);
  for (int round = 0; round < 200; ++round) {
    std::vector<Record> records;
    for (int i = 0; i < 30; ++i) {
      Record record = sample(fmt::format("{}", i), digit(random));
      record.us_per_frame = digit(random);
      if (digit(random) == 0) record.failed = "words";
      if (digit(random) == 0) record.error = k_not_measured;
      if (digit(random) == 0) record.us_per_frame = k_not_measured;
      records.push_back(record);
    }
    std::vector<const Record*> all;
    for (const Record& record : records) all.push_back(&record);

    // Beaten: another is no worse in both, and better in one or earlier
    const auto counts = [](const Record& r) {
      return r.failed.empty() && std::isfinite(r.error)
             && std::isfinite(r.us_per_frame);
    };
    const auto beats = [&](const Record& a, const Record& b) {
      if (!counts(a) || a.error > b.error || a.us_per_frame > b.us_per_frame)
        return false;
      return a.error < b.error || a.us_per_frame < b.us_per_frame || &a < &b;
    };
    std::set<const Record*> expected;
    for (const Record& b : records) {
      const auto beaten = [&](const Record& a) { return beats(a, b); };
      if (counts(b) && std::ranges::none_of(records, beaten)) expected.insert(&b);
    }
    const std::vector<const Record*> found = front(all, Cost::time, 1);
    CHECK(std::set(found.begin(), found.end()) == expected);
    for (std::size_t i = 1; i < found.size(); ++i) {
      CHECK(found[i - 1]->us_per_frame < found[i]->us_per_frame);
      CHECK(found[i - 1]->error > found[i]->error);
    }
  }
}

TEST_CASE("evaluations are counted for a frame of the scene") {
  Record record = sample("k", 1);
  record.evaluations = 400;
  record.steps = 40;  // of 0.25 s
  CHECK(evaluations_per_frame(record, 0.5) == 20);
}

TEST_CASE("an estimate weighs what is left by how wrong its guesses were") {
  Estimate estimate({{"a", 1}, {"b", 1}, {"a", 2}, {"c", 4}});
  CHECK(estimate.seconds_left() == 8);
  estimate.finish(3);  // of group a: three times as long as expected
  CHECK(estimate.seconds_left() == 3 * (1 + 2 + 4));
  estimate.finish(1);  // of group b: all together 4 s for 2
  CHECK(estimate.seconds_left() == 3 * 2 + 2 * 4);
  CHECK(estimate.seconds_spent() == 4);

  Estimate passes({{"errors", 1}, {"more errors", 1}, {"times", 5, true}});
  passes.finish(10);
  CHECK(passes.seconds_left() == 10 + 5);
  passes.finish(10);
  passes.finish(6);
  CHECK(passes.seconds_left() == 0);
  CHECK(duration_text(3) == "3 s");
  CHECK(duration_text(300) == "5 min");
}

TEST_CASE("wrong calls end in one line that says what would be valid") {
  const auto refused = [](std::vector<const char*> words, const std::string& part) {
    words.insert(words.begin(), "study");
    check_says(
        [&] { parse_options("study", static_cast<int>(words.size()), words.data()); },
        part);
  };
  refused({"--shard", "0/3"}, "I from 1 to N");
  refused({"--shard", "4/3"}, "I from 1 to N");
  refused({"--shard", "1"}, "I from 1 to N");
  refused({"--repeats", "0"}, "--repeats 0: must be a whole number from 1");
  refused({"--out", ""}, "--out: the folder's name is empty");
  refused({"--quik"}, "did you mean --quick?");
  refused({"orbitt"}, "did you mean orbit?");
  refused({"--json"}, "--json: only --list prints JSON");
  refused({"--partial"}, "--partial: only --merge");
  refused({"--shard", "1/1", "--merge", "x"}, "exclude each other");
  refused({"--list", "--merge", "x"}, "no --shard or --merge");
  refused({"--list", "--shard", "1/1"}, "no --shard or --merge");
  refused({"--merge", "x", "--quik"}, "did you mean --quick?");
}

namespace {

/// The fields of a line of CSV, without their quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

/// The cells of the study by their keys.
std::map<std::string, Cell> cells_by_key() {
  std::map<std::string, Cell> all;
  for (const Cell& cell : cells(chosen_problems({}), false)) all[key(cell)] = cell;
  return all;
}

}  // namespace

TEST_CASE("what is published is what is computed: a sample of it, bit for bit") {
  constexpr std::size_t k_every = 97;
  constexpr double k_most_steps = 3000;  // others take too long for a test
  std::ifstream in(TIMESTEP_PUBLISHED);
  REQUIRE(in);
  const std::map<std::string, Cell> known = cells_by_key();
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> head = fields_of(line);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(head, name) - head.begin());
  };

  std::size_t row = 0, compared = 0;
  for (; std::getline(in, line); ++row) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.at(column("peer")) == "true") continue;
    INFO(fields.at(0));
    REQUIRE(known.contains(fields.at(0)));
    if (row % k_every != 0 || std::stod(fields.at(column("steps"))) > k_most_steps)
      continue;
    const ErrorResult result = measure_error(known.at(fields.at(0)));
    CHECK(exact_text(result.error) == fields.at(column("error")));
    CHECK(result.failed == fields.at(column("failed")));
    CHECK(fmt::to_string(result.evaluations) == fields.at(column("evaluations")));
    ++compared;
  }
  CHECK(compared >= 30);
}
