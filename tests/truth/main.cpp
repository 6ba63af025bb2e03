// truth FILE… [--kind K] [--precision single|double] [--out computed.json]
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "tests/truth/runner.hpp"

namespace {

using timestep::InputError;
using timestep::truth::Precision;
using timestep::truth::Report;

void print(const Report& report) {
  fmt::print("{:<30} {:>7} {:>7} {:>12}\n", "kind", "passed", "failed", "not covered");
  for (const auto& [kind, tally] : report.kinds)
    fmt::print("{:<30} {:>7} {:>7} {:>12}\n", kind, tally.passed, tally.failed,
               tally.not_covered);
  const auto& total = report.total;
  fmt::print("{:<30} {:>7} {:>7} {:>12}\n", "all", total.passed, total.failed,
             total.not_covered);

  int not_computed = 0;
  for (const auto& outcome : report.outcomes) {
    not_computed += outcome.fields_not_computed;
    if (!outcome.pass) fmt::print("FAILED {}: {}\n", outcome.id, outcome.failure);
  }
  fmt::print("fields of covered cases that are not computed: {}\n", not_computed);
}

// The whole file or none: it is written beside its place and then moved there.
void write(const Report& report, const std::string& file) {
  const std::string part = file + ".part";
  std::ofstream out(part);
  out << to_json(report).dump(1) << '\n';
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, file, failed);
  if (!out || failed) {
    std::filesystem::remove(part, failed);
    throw InputError(fmt::format("--out {}: cannot be written", file));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Computes the cases of truth files with the engine and compares.",
               "truth");
  std::vector<std::filesystem::path> files;
  std::string kind, out;
  Precision precision = Precision::double_bits;
  const std::map<std::string, Precision> names{{"single", Precision::single_bits},
                                               {"double", Precision::double_bits}};
  app.add_option("FILE", files, "truth files")->required();
  app.add_option("--kind", kind, "only this kind of case");
  app.add_option("--precision", precision, "single or double (the default)")
      ->transform(CLI::Transformer(names));
  app.add_option("--out", out, "file for what was computed, as JSON");

  try {
    app.parse(argc, argv);
    const Report report = run_cases(files, kind, precision);
    print(report);
    if (!out.empty()) write(report, out);
    return report.total.failed == 0 ? 0 : 1;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    std::cerr << "truth: " << error.what() << '\n';
    return 2;
  }
}
