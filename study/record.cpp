#include "study/record.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "common/chapter/numbers.hpp"

namespace timestep::study {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (!std::isfinite(value)) return exact_text(value);
  return value;
}

double number_from(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const auto text = json.get<std::string>();
  if (text == "nan") return k_not_measured;
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error("\"" + text + "\" is no number");
}

Json settings_json(const std::map<std::string, double>& settings) {
  Json json = Json::object();
  for (const auto& [name, value] : settings) json[name] = number(value);
  return json;
}

Record read(const Json& json) {
  Record record;
  const auto text = [&](const char* name) { return json.at(name).get<std::string>(); };
  const auto count = [&](const char* name) { return json.at(name).get<long long>(); };
  record.key = text("key");
  record.problem = text("problem");
  record.chapter = text("chapter");
  record.scene = text("scene");
  record.metric = text("metric");
  record.frame = number_from(json.at("frame"));
  record.duration = number_from(json.at("duration"));
  record.method = text("method");
  record.precision = text("precision");
  record.dt = number_from(json.at("dt"));
  for (const auto& [name, value] : json.at("settings").items())
    record.settings[name] = number_from(value);
  record.error = number_from(json.at("error"));
  record.unit = text("unit");
  record.evaluations = count("evaluations");
  record.steps = count("steps");
  record.bodies = count("bodies");
  record.failed = text("failed");
  record.us_per_frame = number_from(json.at("us_per_frame"));
  record.spread = number_from(json.at("spread"));
  record.repeats = json.at("repeats").get<int>();
  record.peer = json.value("peer", false);
  if (!(record.dt > 0)) throw std::runtime_error("dt is not positive");
  if (record.repeats < 0) throw std::runtime_error("repeats are negative");
  return record;
}

/// With 0 apart from -0; all NaN alike.
bool same_bits(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Record record_of(const Cell& cell, const ErrorResult& result) {
  return {.key = key(cell),
          .problem = cell.problem->name,
          .chapter = cell.problem->chapter,
          .scene = cell.problem->scene,
          .metric = cell.problem->metric,
          .frame = cell.problem->frame,
          .duration = cell.problem->duration,
          .method = cell.method,
          .precision = cell.precision,
          .dt = cell.dt,
          .settings = cell.settings,
          .error = result.error,
          .unit = result.unit,
          .evaluations = result.evaluations,
          .steps = result.steps,
          .bodies = result.bodies,
          .failed = result.failed};
}

Record timed(Record record, const TimeResult& time) {
  record.us_per_frame = time.us_per_frame;
  record.spread = time.spread;
  record.repeats = time.repeats;
  return record;
}

bool wants_time(const Record& record) {
  return record.failed.empty() && record.repeats == 0;
}

bool same_but_time(const Record& a, const Record& b) {
  return a.key == b.key && a.settings == b.settings && same_bits(a.error, b.error)
         && a.unit == b.unit && a.evaluations == b.evaluations && a.steps == b.steps
         && a.bodies == b.bodies && a.failed == b.failed;
}

bool belongs_to(const Record& record, const Cell& cell) {
  const Problem& problem = *cell.problem;
  const double steps = std::floor(problem.duration / cell.dt * (1 + 1e-9));
  return record.key == key(cell) && record.settings == cell.settings
         && record.scene == problem.scene && record.metric == problem.metric
         && record.frame == problem.frame && record.duration == problem.duration
         && (!record.failed.empty() || static_cast<double>(record.steps) == steps);
}

std::string to_line(const Record& record) {
  Json json{{"key", record.key},
            {"problem", record.problem},
            {"chapter", record.chapter},
            {"scene", record.scene},
            {"metric", record.metric},
            {"frame", number(record.frame)},
            {"duration", number(record.duration)},
            {"method", record.method},
            {"precision", record.precision},
            {"dt", number(record.dt)},
            {"settings", settings_json(record.settings)},
            {"error", number(record.error)},
            {"unit", record.unit},
            {"evaluations", record.evaluations},
            {"steps", record.steps},
            {"bodies", record.bodies},
            {"failed", record.failed},
            {"us_per_frame", number(record.us_per_frame)},
            {"spread", number(record.spread)},
            {"repeats", record.repeats}};
  if (record.peer) json["peer"] = true;
  return json.dump();
}

Record from_line(const std::string& line) {
  return read(Json::parse(line));
}

double evaluations_per_frame(const Record& record, double frame) {
  const double time = static_cast<double>(record.steps) * record.dt;
  return static_cast<double>(record.evaluations) * frame / time;
}

}  // namespace timestep::study
