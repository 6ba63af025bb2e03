// ingredients: what each ingredient of the physics costs, and the error without it.
#include <filesystem>
#include <fstream>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/chapter/console.hpp"
#include "common/chapter/numbers.hpp"
#include "common/chapter/outputs.hpp"
#include "common/graphics/input_error.hpp"
#include "study/exit_code.hpp"
#include "study/ingredients/ingredients.hpp"

using namespace timestep;
using Json = nlohmann::ordered_json;

namespace {

struct Options {
  std::string json;  // a file, or "-"
  int repeats = 41;
};

// Nothing if --help was all
std::optional<Options> read_options(int argc, char** argv) {
  Options options;
  CLI::App app{"What each ingredient costs, and the error that its absence causes"};
  bool is_quick = false, errors_only = false;
  app.add_option("--json", options.json,
                 "write the rows to a file, - for standard output");
  app.add_flag("--quick", is_quick, "three repeats in place of 41");
  app.add_flag("--errors-only", errors_only, "measure no time");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print_out(app.help());
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw InputError(error.what());
  }
  if (is_quick) options.repeats = 3;
  if (errors_only) options.repeats = 0;
  return options;
}

constexpr const char* k_line = "{:22} {:44} {:>10} {:>10} {:4} {:>9} {:>9}\n";

void print(const Json& row) {
  const auto text = [&](const char* key) {
    return row.contains(key) ? short_text(row[key].get<double>()) : "-";
  };
  print_out(fmt::format(k_line, row["ingredient"].get<std::string>(),
                        row["scene"].get<std::string>(), text("error_with"),
                        text("error_without"), row["unit"].get<std::string>(),
                        text("ns_more"), text("spread")));
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) throw InputError(file.string() + ": cannot be written");
}

void run(const Options& options) {
  const bool prints_json = options.json == "-";
  const bool writes_json = !prints_json && !options.json.empty();
  Outputs outputs;
  std::filesystem::path staged;
  if (writes_json) staged = outputs.stage("--json", options.json);

  if (!prints_json)
    print_out(fmt::format(k_line, "ingredient", "scene", "error with", "without", "",
                          "ns more", "spread"));
  Json rows = Json::array();
  for (const study::Comparison& comparison : study::ingredients()) {
    rows.push_back(study::row_of(comparison, options.repeats));
    if (!prints_json) print(rows.back());
  }
  const Json document{{"compiler", TIMESTEP_COMPILER}, {"rows", rows}};
  if (prints_json) print_out(document.dump(1) + "\n");
  if (writes_json) write(staged, document.dump(1) + "\n");
  outputs.publish();
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  return study::exit_code_of("ingredients", [&] {
    if (const auto options = read_options(argc, argv)) run(*options);
  });
}
