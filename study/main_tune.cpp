// tune PROBLEM --error 1mm | --budget 50us: the cheapest setting that is right enough,
// or the most accurate one that is cheap enough.
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/chapter/numbers.hpp"
#include "common/chapter/runner.hpp"
#include "common/graphics/input_error.hpp"
#include "study/quantity.hpp"
#include "study/run.hpp"
#include "study/tune_report.hpp"

namespace timestep::study {
namespace {

struct Request {
  std::string scene;
  std::optional<std::string> error, budget, seconds;
  bool quick = false, json = false;
};

void add_options(CLI::App& app, Request& request) {
  app.add_option("scene", request.scene, "a problem of the study, or its scene")
      ->type_name("SCENE");
  app.add_option("--error", request.error, "at most so large: 1mm, 0.1%, 2deg, 1e-3")
      ->type_name("X");
  app.add_option("--budget", request.budget, "a frame costs at most: 50us, 0.1ms")
      ->type_name("T");
  app.add_option("--seconds", request.seconds,
                 "try so long at most (default 20, with --quick 5)")
      ->type_name("N");
  app.add_flag("--quick", request.quick, "only every second step and setting");
  app.add_flag("--json", request.json, "print JSON");
}

// Nothing after --help, which it answers
std::optional<Request> parse(int argc, char** argv) {
  Request request;
  CLI::App app{
      "The cheapest setting of a scene that meets an error, or the most "
      "accurate\nwithin a budget.",
      "tune"};
  add_options(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print_out(app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    const std::string text = error.what();
    throw InputError(text.substr(0, text.find('\n')));
  }
  if (request.scene.empty()) throw InputError("which scene? See study --list");
  if (request.error.has_value() == request.budget.has_value())
    throw InputError("give either --error or --budget");
  return request;
}

// A scene may be shown by several problems; a problem's own name comes first
const Problem& problem_named(const std::string& name) {
  const std::vector<const Problem*> meant = chosen_problems({&name, 1});
  std::string names;
  for (const Problem* problem : meant) {
    if (problem->name == name) return *problem;
    names += (names.empty() ? "" : ", ") + problem->name;
  }
  if (meant.size() == 1) return *meant.front();
  throw InputError(fmt::format("{} is several problems: {}", name, names));
}

// The unit of the problem's metric
std::string unit_of(const Cell& cell) {
  const Plan plan = plan_of(cell);
  const std::vector<Lane> lanes = start_lanes(plan);
  for (const Metric& metric : lanes.front().simulation->metrics())
    if (metric.name == cell.problem->metric) return metric.unit;
  return "";
}

Wish wish_of(const Request& request, const std::string& unit) {
  if (request.error)
    return {Wish::Kind::error, parse_quantity("--error", *request.error, unit)};
  return {Wish::Kind::budget, parse_quantity("--budget", *request.budget, "us")};
}

Patience patience_of(const Request& request) {
  using Clock = std::chrono::steady_clock;
  const std::string typed = request.seconds.value_or(request.quick ? "5" : "20");
  const auto limit = parse_number(typed);
  if (!limit || *limit <= 0)
    throw InputError(fmt::format("--seconds {}: must be a positive number", typed));
  const auto end = Clock::now() + std::chrono::duration<double>(*limit);
  return {.longest_run = *limit / 6, .is_over = [end] {
            throw_if_interrupted();
            return Clock::now() > end;
          }};
}

// Exit code 0 if the wish is met, else 1
int run(const Request& request) {
  const Problem& problem = problem_named(request.scene);
  const std::array<const Problem*, 1> chosen{&problem};
  const std::vector<Cell> grid = cells(chosen, request.quick);
  const std::string unit = unit_of(grid.front());
  const Wish wish = wish_of(request, unit);
  const Meter meter{measure_error, [](const Cell& cell) { return measure_time(cell); }};
  Outcome outcome;
  {
    Progress progress;
    outcome = tune(grid, wish, meter, patience_of(request),
                   [&](double share) { progress.show(share); });
  }
  print_out(request.json ? report_json(problem, wish, outcome, unit).dump(1) + "\n"
                         : report(problem, wish, outcome, unit, 25));
  return outcome.met ? 0 : 1;
}

}  // namespace
}  // namespace timestep::study

int main(int argc, char** argv) {
  using namespace timestep;
  int answer = 0;
  const int code = study::exit_code_of("tune", [&] {
    keep_standard_streams();
    note_interrupts();
    try {
      const auto request = study::parse(argc, argv);
      if (request) answer = study::run(*request);
    } catch (const Interrupted&) {  // nothing is kept
      print_note("tune", "interrupted");
      answer = 130;
    }
  });
  return code != 0 ? code : answer;
}
