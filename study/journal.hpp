/// @file
/// Results on disk, a line each, so that nothing that was computed is ever lost.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "study/record.hpp"

namespace timestep::study {

/// A file to whose end records are written, and what it held when it was opened. A line
/// is on the disk before `append` returns; nobody else can open it meanwhile.
class Journal {
 public:
  /// Opens or makes the file, and its folder. A torn last line, as a run that was
  /// killed leaves behind, is cut off. Throws InputError in one line if the file is in
  /// use by another process, cannot be written, or holds a line that is no record.
  explicit Journal(const std::filesystem::path& file);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Throws InputError if the disk does not take it.
  void append(const Record& record);

  /// Takes what other journals hold as found; the file stays as it is.
  void know(const std::vector<Record>& others);

  /// The last record of that key; none: nullptr.
  const Record* find(const std::string& key) const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::map<std::string, Record> records_;
};

/// All whole lines of a journal, in their order. Throws InputError as the constructor.
std::vector<Record> read_journal(const std::filesystem::path& file);

}  // namespace timestep::study
