// One process: computes the study, or a shard of it, or merges shards.
#include "common/chapter/console.hpp"
#include "study/run.hpp"

namespace {

using namespace timestep;

void work(int argc, char** argv) {
  const study::Options options = study::parse_options("study", argc, argv);
  if (options.answer) return print_out(*options.answer);
  if (options.list) return print_out(study::listing(options));
  if (options.merge.empty()) study::compute(options, *study::open_journal(options));
  if (options.shards == 1) study::merge_and_write(options);
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  return study::exit_code_of(
      "study", [&] { work(argc, argv); }, study::k_goes_on);
}
