// study-peers-PRECISION [SCENE…]: what other libraries make of the study's problems,
// into a journal beside the study's own.
#include <chrono>
#include <vector>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/graphics/input_error.hpp"
#include "study/estimate.hpp"
#include "study/exit_code.hpp"
#include "study/journal.hpp"
#include "study/options.hpp"
#include "study/peers/measure.hpp"

namespace timestep::study {
namespace {

constexpr const char* k_program = "study-peers-" TIMESTEP_PEERS;

/// As the study's own program is called, but for what peers cannot be asked.
Options parse(int argc, char** argv) {
  Options options = parse_options(k_program, argc, argv);
  if (options.shards > 1 || !options.merge.empty() || options.list)
    throw InputError("peers are measured by one process, all at once");
  return options;
}

void measure(const Peer& peer, const Cell& cell, const Options& options,
             Journal& journal) {
  throw_if_interrupted();
  if (journal.find(key(cell)) == nullptr) {
    Record record = record_of(cell, measure_error(peer, cell));
    record.peer = true;
    journal.append(record);
  }
  const Record record = *journal.find(key(cell));
  if (options.times && wants_time(record))
    journal.append(timed(record, measure_time(peer, cell, options.repeats)));
}

struct Question {
  const Peer* peer = nullptr;
  Cell cell;
};

std::vector<Question> questions(const std::vector<Peer>& peers,
                                const Options& options) {
  std::vector<Question> all;
  for (const Problem* problem : studied_problems(options.names, options.quick))
    for (const Peer& peer : peers)
      for (const Cell& cell : cells_of(peer, *problem, options.quick))
        all.push_back({&peer, cell});
  return all;
}

Estimate estimate_of(const std::vector<Question>& all, const Options& options) {
  constexpr double k_step = 1e-5;  // [s] roughly, of whatever library
  std::vector<Task> tasks;
  for (const auto& [peer, cell] : all) {
    const double run = k_step * cell.problem->duration / cell.dt;
    const double timing = options.times ? expected_timing(run, options.repeats) : 0;
    tasks.push_back({cell.problem->name + "/" + peer->method, run + timing});
  }
  return Estimate(std::move(tasks));
}

void run(const Options& options) {
  note_interrupts();
  using Clock = std::chrono::steady_clock;
  Journal journal(options.out / "journal-peers-" TIMESTEP_PEERS ".jsonl");
  const std::vector<Peer> all_peers = peers();
  const std::vector<Question> all = questions(all_peers, options);
  Estimate estimate = estimate_of(all, options);
  ProgressBar bar;
  for (const auto& [peer, cell] : all) {
    bar.show(estimate, "peers");
    const auto begin = Clock::now();
    measure(*peer, cell, options, journal);
    estimate.finish(std::chrono::duration<double>(Clock::now() - begin).count());
  }
}

}  // namespace
}  // namespace timestep::study

int main(int argc, char** argv) {
  using namespace timestep;
  keep_standard_streams();
  const auto work = [&] {
    const study::Options options = study::parse(argc, argv);
    if (options.answer) return print_out(*options.answer);
    study::run(options);
  };
  return study::exit_code_of(study::k_program, work, study::k_goes_on);
}
