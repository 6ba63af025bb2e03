/// @file
/// The command line of `study` and `study-mpi`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace timestep::study {

struct Options {
  std::vector<std::string> names;            ///< problems or scenes; none: all
  bool quick = false;                        ///< a part that takes less than a minute
  bool list = false, json = false;           ///< only say what would be done
  bool times = true;                         ///< false: errors alone
  bool partial = false;                      ///< merge what there is
  bool shows_progress = true;                ///< on standard error
  int repeats = 3;                           ///< least number of timed runs of a cell
  int shard = 1, shards = 1;                 ///< this one of so many, from 1
  bool is_shard = false;                     ///< --shard was given
  std::filesystem::path out{"out/study"};    ///< folder
  std::vector<std::filesystem::path> merge;  ///< folders or journals; none: compute
  std::optional<std::string> answer;         ///< print this and end: --help
};

/// Throws InputError, in one line, for an unknown option or scene (with the nearest
/// ones), a missing or malformed value, or options that contradict each other.
Options parse_options(const std::string& program, int argc, const char* const* argv);

}  // namespace timestep::study
