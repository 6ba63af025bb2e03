// truth FILE… [--kind K] [--precision single|double] [--out computed.json]
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/chapter/console.hpp"
#include "common/chapter/outputs.hpp"
#include "common/graphics/input_error.hpp"
#include "tests/truth/runner.hpp"

namespace {

using timestep::InputError;
using timestep::truth::Precision;
using timestep::truth::Report;

// The command line as it was typed.
struct Wanted {
  std::vector<std::filesystem::path> files;
  std::string kind, precision = "double";
  std::optional<std::string> out;
};

std::string row(const std::string& kind, const timestep::truth::Tally& tally) {
  return fmt::format("{:<30} {:>7} {:>7} {:>12}\n", kind, tally.passed, tally.failed,
                     tally.not_covered);
}

std::string text_of(const Report& report) {
  std::string text = fmt::format("{:<30} {:>7} {:>7} {:>12}\n", "kind", "passed",
                                 "failed", "not covered");
  for (const auto& [kind, tally] : report.kinds) text += row(kind, tally);
  text += row("all", report.total);

  int not_computed = 0;
  for (const auto& outcome : report.outcomes) {
    not_computed += outcome.fields_not_computed;
    if (!outcome.pass)
      text += fmt::format("FAILED {}: {}\n", outcome.id, outcome.failure);
  }
  return text
         + fmt::format("fields of covered cases that are not computed: {}\n",
                       not_computed);
}

void write(const Report& report, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << to_json(report).dump(1) << '\n';
  out.close();
  if (!out) throw InputError("--out: cannot be written to the end");
}

Precision parse_precision(const std::string& text) {
  if (text == "single") return Precision::single_bits;
  if (text == "double") return Precision::double_bits;
  throw InputError(fmt::format("--precision {}: must be single or double", text));
}

// Runs the cases; the file, if one is wanted, appears whole or not at all.
int run(const Wanted& wanted) {
  const Precision precision = parse_precision(wanted.precision);
  const Report report = run_cases(wanted.files, wanted.kind, precision);
  timestep::Outputs outputs;
  if (wanted.out) write(report, outputs.stage("--out", *wanted.out));
  outputs.publish();
  timestep::print_out(text_of(report));
  return report.total.failed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  timestep::keep_standard_streams();
  CLI::App app("Computes the cases of truth files with the engine and compares.",
               "truth");
  Wanted wanted;
  app.add_option("FILE", wanted.files, "truth files")->required();
  app.add_option("--kind", wanted.kind, "only this kind of case");
  app.add_option("--precision", wanted.precision, "single or double (the default)");
  app.add_option("--out", wanted.out, "file for what was computed, as JSON");

  try {
    app.parse(argc, argv);
    return run(wanted);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    timestep::print_note("truth", error.what());
    return 2;
  }
}
