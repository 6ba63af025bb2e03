/// @file
/// Runs truth cases through the engine and compares.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/truth/kind.hpp"

namespace timestep::truth {

enum class Precision { single_bits, double_bits };

/// One case that the engine covers.
struct Outcome {
  std::string id, kind;
  Json computed;
  bool pass = false;
  int fields_not_computed = 0;
  std::string failure{};  ///< the first field that is off; empty if none
};

struct Tally {
  int passed = 0, failed = 0, not_covered = 0;
};

struct Report {
  std::vector<Outcome> outcomes;  ///< of the covered cases, in the files' order
  std::vector<std::pair<std::string, Tally>> kinds;  ///< in order of appearance
  Tally total;
};

/// All cases of the files, or those of one kind if `kind` is not empty. Throws
/// InputError if a file is missing, is not of the truth schema, or has no case of that
/// kind.
Report run_cases(const std::vector<std::filesystem::path>& files,
                 const std::string& kind, Precision precision);

/// {"cases": [{"id", "kind", "computed", "pass"}]}.
Json to_json(const Report& report);

}  // namespace timestep::truth
