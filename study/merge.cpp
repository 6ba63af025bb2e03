#include "study/merge.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"
#include "study/journal.hpp"

namespace timestep::study {
namespace {

namespace fs = std::filesystem;

/// A record, and the journal that it stands in.
struct Found {
  Record record;
  fs::path journal;
};

using AllFound = std::map<std::string, Found>;

void add(AllFound& all, Record record, const fs::path& journal) {
  const auto [place, is_new] = all.try_emplace(record.key, Found{record, journal});
  if (is_new) return;
  Found& before = place->second;
  if (!same_but_time(before.record, record))
    throw InputError(fmt::format("{}: {} and {} disagree: an error of {} and of {}",
                                 record.key, before.journal.string(), journal.string(),
                                 exact_text(before.record.error),
                                 exact_text(record.error)));
  if (before.record.repeats == 0) before = {std::move(record), journal};
}

/// Of a problem's peers; a map, so that they come by key.
void add_peers(std::vector<Record>& records, const AllFound& all,
               const std::string& problem) {
  for (const auto& [key, found] : all)
    if (found.record.peer && found.record.problem == problem)
      records.push_back(found.record);
}

bool is_complete(const Record& record, bool times) {
  return !times || !wants_time(record);
}

/// Counts what is missing, and remembers the first.
struct Missing {
  std::size_t count = 0;
  std::string first{};

  void note(const std::string& key) {
    if (count++ == 0) first = key;
  }
};

void refuse(const Missing& missing, std::size_t all) {
  if (missing.count == 0) return;
  throw InputError(
      fmt::format("{} of {} cells are missing, or their times; the first "
                  "is {}; compute them, or add --partial",
                  missing.count, all, missing.first));
}

}  // namespace

std::vector<fs::path> journals_of(std::span<const fs::path> places) {
  std::set<fs::path> journals;
  for (const fs::path& place : places) {
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) {
      if (!fs::is_regular_file(place, ignored))
        throw InputError(
            fmt::format("--merge {}: is neither a folder nor a file", place.string()));
      journals.insert(place);
      continue;
    }
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error))
      if (entry.path().extension() == ".jsonl") journals.insert(entry.path());
    if (error)
      throw InputError(
          fmt::format("{}: cannot be read: {}", place.string(), error.message()));
  }
  if (journals.empty())
    throw InputError(
        fmt::format("--merge {}: there is no journal", places.front().string()));
  return {journals.begin(), journals.end()};
}

std::vector<Record> merge(std::span<const fs::path> journals, const Wanted& wanted) {
  AllFound all;
  for (const fs::path& journal : journals)
    for (Record& record : read_journal(journal)) add(all, std::move(record), journal);

  std::vector<Record> records;
  Missing missing;
  for (std::size_t i = 0; i < wanted.cells.size(); ++i) {
    const Cell& cell = wanted.cells[i];
    const auto found = all.find(key(cell));
    const bool there = found != all.end() && belongs_to(found->second.record, cell);
    if (!there || !is_complete(found->second.record, wanted.times))
      missing.note(key(cell));
    if (there) records.push_back(found->second.record);
    const bool last = i + 1 == wanted.cells.size();
    if (last || wanted.cells[i + 1].problem != cell.problem)
      add_peers(records, all, cell.problem->name);
  }
  if (!wanted.partial) refuse(missing, wanted.cells.size());
  if (records.empty()) throw InputError("no journal has a record of what is wanted");
  return records;
}

}  // namespace timestep::study
