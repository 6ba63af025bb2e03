#include "common/chapter/file_job.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/chapter/names.hpp"
#include "common/chapter/results_file.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

std::string choose_method(const FileJob& job, const std::vector<std::string>& asked) {
  if (asked.empty()) return job.methods.at(0).name;
  if (asked.size() > 1)
    throw InputError(fmt::format("--method: --{} takes one method", job.option));
  std::vector<std::string> names;
  for (const Method& method : job.methods) names.push_back(method.name);
  if (std::ranges::find(names, asked[0]) == names.end())
    throw InputError(unknown_name("method of --" + job.option, asked[0], names));
  return asked[0];
}

}  // namespace

void run_file_job(const Chapter& chapter, const Options& options) {
  const FileJob& job = *options.job;
  const std::string method = choose_method(job, options.choice.methods);
  const Precision precision = parse_precision(options.choice.precision);
  note_interrupts();
  Outputs outputs;
  const std::filesystem::path place = stage_results(outputs, chapter, options);

  const FileJob::Run& run =
      precision == Precision::single_bits ? job.single_precision : job.double_precision;
  write_results(place, options, run(options.job_file, method));
  outputs.publish();
  if (options.results != "-")
    print_out(fmt::format("the results are in {}\n",
                          results_place(chapter, options).string()));
}

}  // namespace timestep
