// Under mpirun: every rank computes one shard, then the first one merges all.
#include <mpi.h>

#include "common/chapter/console.hpp"
#include "common/graphics/input_error.hpp"
#include "study/run.hpp"

namespace {

using namespace timestep;

study::Options options_of_rank(int argc, char** argv, int rank, int ranks) {
  study::Options options = study::parse_options("study-mpi", argc, argv);
  if (options.is_shard || !options.merge.empty() || options.list)
    throw InputError("--shard, --merge and --list are for study: ranks are shards");
  options.shard = rank + 1;
  options.shards = ranks;
  options.shows_progress = rank == 0;
  return options;
}

/// The worst exit code of all ranks, so that nobody goes on where another cannot.
int together(const std::function<void()>& work) {
  const int code = study::exit_code_of("study-mpi", work, study::k_goes_on);
  int worst = 0;
  MPI_Allreduce(&code, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return worst;
}

int work(int argc, char** argv, int rank, int ranks) {
  study::Options options;
  const auto read = [&] { options = options_of_rank(argc, argv, rank, ranks); };
  // One says what is wrong with the call
  int code = together([&] {
    if (rank == 0) read();
  });
  if (code != 0) return code;
  read();
  if (options.answer) {
    return together([&] {
      if (rank == 0) print_out(*options.answer);
    });
  }

  std::unique_ptr<study::Journal> journal;
  code = together([&] { journal = study::open_journal(options); });
  if (code == 0) code = together([&] { study::compute(options, *journal); });
  if (code != 0) return code;
  return together([&] {
    if (rank == 0) study::merge_and_write(options);
  });
}

}  // namespace

int main(int argc, char** argv) {
  timestep::keep_standard_streams();
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int code = work(argc, argv, rank, ranks);
  MPI_Finalize();
  return code;
}
