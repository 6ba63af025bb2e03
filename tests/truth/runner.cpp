#include "tests/truth/runner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "common/chapter/json_file.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::truth {
namespace {

Json load(const std::filesystem::path& file) {
  Json document = load_json(file);
  if (!document.is_object() || !document.value("cases", Json()).is_array())
    throw InputError(
        fmt::format("{}: not a truth file: no list of cases", file.string()));
  return document;
}

std::string id_of(const Json& test) {
  const bool named =
      test.is_object() && test.contains("id") && test.at("id").is_string();
  return named ? test.at("id").get<std::string>() : "without id";
}

// The library of the wanted precision comes first. Cases that name a precision of their
// own (float_spacing, say) are refused by one of the two and so reach the other.
std::vector<Kind> find_kinds(const std::string& name, Precision precision) {
  std::vector<std::span<const Kind>> libraries{
      single_precision::truth_kinds_01(),
      single_precision::truth_kinds_02(),
      single_precision::truth_kinds_02_motions(),
      single_precision::truth_kinds_03_exact(),
      single_precision::truth_kinds_03_mass(),
      single_precision::truth_kinds_03_rotation(),
      single_precision::truth_kinds_04(),
      single_precision::truth_kinds_06(),
      single_precision::truth_kinds_06_exact(),
      single_precision::truth_kinds_06_motions(),
      double_precision::truth_kinds_01(),
      double_precision::truth_kinds_02(),
      double_precision::truth_kinds_02_motions(),
      double_precision::truth_kinds_03_exact(),
      double_precision::truth_kinds_03_mass(),
      double_precision::truth_kinds_03_rotation(),
      double_precision::truth_kinds_04(),
      double_precision::truth_kinds_06(),
      double_precision::truth_kinds_06_exact(),
      double_precision::truth_kinds_06_motions()};
  if (precision == Precision::double_bits) std::ranges::reverse(libraries);

  std::vector<Kind> found;
  for (const std::span<const Kind> library : libraries)
    std::ranges::copy_if(library, std::back_inserter(found),
                         [&](const Kind& kind) { return kind.name == name; });
  return found;
}

// What single precision may cost in the fields of a case; none of them in double.
Json derived_tolerance(const Json& test, Precision precision) {
  if (precision == Precision::double_bits) return Json::object();
  for (const auto& all : {single_tolerances(), single_tolerances_03_mass(),
                          single_tolerances_03_rotation(), single_tolerances_06()}) {
    const auto found = std::ranges::find(all, test.at("kind"), &Kind::name);
    if (found != all.end()) return found->compute(test.at("inputs"));
  }
  return Json::object();
}

// The numbers in a value; null is one, too, that is close to nothing but null.
std::vector<double> components(const Json& value) {
  if (value.is_number()) return {value.get<double>()};
  if (value.is_null()) return {std::numeric_limits<double>::quiet_NaN()};
  if (!value.is_array()) throw InputError("expected: must be numbers or lists of them");
  std::vector<double> all;
  for (const Json& part : value) {
    const std::vector<double> inner = components(part);
    all.insert(all.end(), inner.begin(), inner.end());
  }
  return all;
}

bool all_close(const Json& got, const Json& expected, double rel, double abs,
               const Json& extra);

// |got - expected| <= abs + rel max|expected| + extra; NaN never passes. A word, true
// and false must be the same; where a number is computed, they are refused.
bool close(const Json& got, const Json& expected, double rel, double abs,
           const Json& extra) {
  if (expected.is_object() && got.is_object())
    return all_close(got, expected, rel, abs, extra);
  const bool is_word = expected.is_string() || expected.is_boolean();
  if (is_word && got.type() == expected.type()) return got == expected;
  if (got.is_null() && expected.is_null()) return true;
  const std::vector<double> g = components(got);
  const std::vector<double> e = components(expected);
  std::vector<double> x = components(extra);
  if (x.size() == 1) x.resize(e.size(), x.front());
  if (g.size() != e.size() || g.size() != x.size()) return false;
  double largest = 0;
  for (const double each : e) largest = std::max(largest, std::abs(each));
  for (std::size_t i = 0; i < g.size(); ++i)
    if (!std::isfinite(g[i]) || !(std::abs(g[i] - e[i]) <= abs + rel * largest + x[i]))
      return false;
  return true;
}

// The same of every field of an object; `extra` is one, or holds for all fields.
bool all_close(const Json& got, const Json& expected, double rel, double abs,
               const Json& extra) {
  return std::ranges::all_of(expected.items(), [&](const auto& field) {
    const Json more = extra.is_object() ? extra.value(field.key(), Json(0.0)) : extra;
    return got.contains(field.key())
           && close(got.at(field.key()), field.value(), rel, abs, more);
  });
}

// A quaternion and its opposite are one orientation. The files hold the one whose first
// number that is not 0 is positive; rounding may make another number the first
bool is_quaternion(const std::string& name, const Json& value) {
  return (name == "q" || name == "q0" || name.starts_with("q_")) && value.size() == 4;
}

Json opposite(Json q) {
  for (Json& part : q) part = -part.get<double>();
  return q;
}

Json with_files_signs(Json computed) {
  const auto is_not_0 = [](const Json& part) { return part != 0.0; };
  for (const auto& [name, value] : computed.items()) {
    if (!is_quaternion(name, value)) continue;
    const auto first = std::ranges::find_if(value, is_not_0);
    if (first != value.end() && *first < 0.0) value = opposite(value);
  }
  return computed;
}

// `stated` has what is compared: `expected` and `tol`
Outcome compare(const Json& test, const Json& stated, const Json& computed,
                const Json& tolerance) {
  Outcome outcome{.id = test.at("id"), .kind = test.at("kind"), .computed = computed};
  if (!test.at("expected").is_object() || test.at("expected").empty())
    throw InputError("expected: must be an object with at least one field");
  const double rel = stated.at("tol").at("rel");
  const double abs = stated.at("tol").at("abs");
  for (const auto& [name, expected] : stated.at("expected").items()) {
    if (!computed.contains(name)) {
      ++outcome.fields_not_computed;
      continue;
    }
    const Json& got = computed.at(name);
    const Json extra = tolerance.value(name, Json(0.0));
    const bool passes = close(got, expected, rel, abs, extra)
                        || (is_quaternion(name, got)
                            && close(opposite(got), expected, rel, abs, extra));
    if (!passes && outcome.failure.empty())
      outcome.failure =
          fmt::format("{}: computed {}, expected {}, tolerance {:.3g} + {}", name,
                      got.dump(), expected.dump(), abs, extra.dump());
  }
  outcome.pass = outcome.failure.empty() && !computed.empty();
  return outcome;
}

bool run_case(const Json& test, Precision precision, Outcome& outcome) {
  for (const Kind& kind : find_kinds(test.at("kind"), precision)) {
    try {
      const Json computed = with_files_signs(kind.compute(test.at("inputs")));
      const Json stated = kind.restate == nullptr ? test : kind.restate(test, computed);
      outcome = compare(test, stated, computed, derived_tolerance(test, precision));
      return true;
    } catch (const NotCovered&) {
      return false;
    } catch (const OtherPrecision&) {
      continue;
    }
  }
  return false;
}

Tally& tally_of(Report& report, const std::string& kind) {
  const auto found =
      std::ranges::find(report.kinds, kind, &std::pair<std::string, Tally>::first);
  if (found != report.kinds.end()) return found->second;
  return report.kinds.emplace_back(kind, Tally{}).second;
}

void add(Report& report, const Json& test, Precision precision) {
  Outcome outcome;
  Tally& tally = tally_of(report, test.at("kind"));
  if (!run_case(test, precision, outcome)) {
    ++tally.not_covered;
    ++report.total.not_covered;
    return;
  }
  ++(outcome.pass ? tally.passed : tally.failed);
  ++(outcome.pass ? report.total.passed : report.total.failed);
  report.outcomes.push_back(std::move(outcome));
}

}  // namespace

Report run_cases(const std::vector<std::filesystem::path>& files,
                 const std::string& kind, Precision precision) {
  Report report;
  for (const std::filesystem::path& file : files) {
    const Json document = load(file);
    for (const Json& test : document.at("cases")) {
      try {
        if (kind.empty() || test.at("kind") == kind) add(report, test, precision);
      } catch (const std::exception& error) {
        throw InputError(
            fmt::format("{}: case {}: {}", file.string(), id_of(test), error.what()));
      }
    }
  }
  if (report.kinds.empty())
    throw InputError(kind.empty() ? "no cases" : "no case of kind '" + kind + "'");
  return report;
}

Json to_json(const Report& report) {
  Json cases = Json::array();
  for (const Outcome& o : report.outcomes)
    cases.push_back(
        {{"id", o.id}, {"kind", o.kind}, {"computed", o.computed}, {"pass", o.pass}});
  return {{"cases", cases}};
}

}  // namespace timestep::truth
