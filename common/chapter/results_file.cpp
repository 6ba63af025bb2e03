#include "common/chapter/results_file.hpp"

#include <fstream>

#include <fmt/format.h>

#include "common/chapter/console.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {

namespace fs = std::filesystem;

fs::path output_folder(const Chapter& chapter, const Options& options) {
  return options.out.value_or(fs::path("out") / chapter.name);
}

fs::path results_place(const Chapter& chapter, const Options& options) {
  if (options.results) return *options.results;
  return output_folder(chapter, options) / "results.json";
}

fs::path stage_results(Outputs& outputs, const Chapter& chapter,
                       const Options& options) {
  if (options.results == "-") return {};
  return outputs.stage(options.results ? "--results" : "--out",
                       results_place(chapter, options));
}

void write_results(const fs::path& place, const Options& options,
                   const std::string& json) {
  if (place.empty()) return print_out(json);
  std::ofstream file(place);
  file << json << std::flush;
  if (!file) {
    throw InputError(fmt::format(
        "{}: cannot be written to the end",
        options.results ? "--results " + *options.results : "--out: results.json"));
  }
}

}  // namespace timestep
