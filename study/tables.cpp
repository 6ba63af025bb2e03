// The records as CSV, as JSON, and the fronts as Markdown.
#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/chapter/numbers.hpp"
#include "common/chapter/outputs.hpp"
#include "common/graphics/input_error.hpp"
#include "study/front.hpp"
#include "study/merge.hpp"

namespace timestep::study {
namespace {

/// As RFC 4180 has it: in quotes where a comma, a quote or a line's end is in it.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? std::string("\"\"") : std::string(1, c);
  return all + "\"";
}

/// "iterations=10 n=5"
std::string settings_text(const std::map<std::string, double>& settings) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : settings)
    parts.push_back(name + "=" + exact_text(value));
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string csv_line(const Record& r) {
  const std::vector<std::string> fields{quoted(r.key),
                                        r.problem,
                                        r.chapter,
                                        r.scene,
                                        r.metric,
                                        exact_text(r.frame),
                                        quoted(r.method),
                                        r.precision,
                                        exact_text(r.dt),
                                        settings_text(r.settings),
                                        exact_text(r.error),
                                        quoted(r.unit),
                                        fmt::to_string(r.evaluations),
                                        fmt::to_string(r.steps),
                                        fmt::to_string(r.bodies),
                                        quoted(r.failed),
                                        r.peer ? "true" : "false",
                                        exact_text(r.us_per_frame),
                                        exact_text(r.spread),
                                        fmt::to_string(r.repeats)};
  return fmt::format("{}\n", fmt::join(fields, ","));
}

std::string front_of(const Problem& problem,
                     std::span<const Record* const> of_problem) {
  const auto is_timed = [](const Record* record) { return record->repeats > 0; };
  const bool times = std::ranges::any_of(of_problem, is_timed);
  const Cost cost = times ? Cost::time : Cost::evaluations;
  const std::string& unit = of_problem.front()->unit;
  std::string text = fmt::format(
      "## {}\n\n{} of {}, from: {}.\n\n| {} | {}{} | setting |\n"
      "|---:|---:|---|\n",
      problem.name, problem.metric, problem.scene, problem.exact,
      times ? "µs a frame" : "evaluations a frame", problem.metric,
      unit.empty() ? "" : " [" + unit + "]");
  for (const Record* record : front(of_problem, cost, problem.frame)) {
    const double paid =
        times ? record->us_per_frame : evaluations_per_frame(*record, problem.frame);
    text += fmt::format("| {:.3g} | {:.2g} | {} |\n", paid, record->error,
                        record->key.substr(problem.name.size() + 1));
  }
  return text + "\n";
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) throw InputError(file.string() + ": cannot be written");
}

}  // namespace

std::string csv_text(std::span<const Record> records) {
  std::string text =
      "key,problem,chapter,scene,metric,frame,method,precision,dt,settings,error,"
      "unit,evaluations,steps,bodies,failed,peer,us_per_frame,spread,"
      "repeats\n";
  for (const Record& record : records) text += csv_line(record);
  return text;
}

std::string json_text(std::span<const Record> records) {
  std::vector<std::string> lines;
  for (const Record& record : records) lines.push_back(to_line(record));
  return fmt::format("[\n{}\n]\n", fmt::join(lines, ",\n"));
}

std::string front_text(std::span<const Record> records) {
  std::string text = "# What no other setting beats in both error and cost\n\n";
  for (const Problem& problem : problems()) {
    std::vector<const Record*> of_problem;
    for (const Record& record : records)
      if (record.problem == problem.name) of_problem.push_back(&record);
    if (!of_problem.empty()) text += front_of(problem, of_problem);
  }
  return text;
}

void write_tables(std::span<const Record> records,
                  const std::filesystem::path& folder) {
  Outputs outputs;
  write(outputs.stage("--out", folder / "study.csv"), csv_text(records));
  write(outputs.stage("--out", folder / "study.json"), json_text(records));
  write(outputs.stage("--out", folder / "front.md"), front_text(records));
  outputs.publish();
}

}  // namespace timestep::study
