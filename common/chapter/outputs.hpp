/// @file
/// The files of one run: written out of sight, shown together when all are complete.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace timestep {

/// Collects files under temporary names beside their places. `publish` renames them
/// all; without it, the destructor takes back every file and folder that was made.
class Outputs {
 public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Where to write what shall appear as `target`: an empty file that exists already,
  /// so that a place that cannot be written is found before the work. Makes missing
  /// folders. A device such as /dev/null is its own temporary. Throws InputError, in a
  /// line that begins with `option`, if the place is a folder, a link to nowhere or
  /// staged already, or cannot be written.
  std::filesystem::path stage(const std::string& option,
                              const std::filesystem::path& target);

  /// Gives up one staged file, such as a movie that failed.
  void discard(const std::filesystem::path& temporary);

  /// Shows everything that was staged. Throws InputError if a file cannot be renamed.
  void publish();

 private:
  void make_folder(const std::string& option, const std::filesystem::path& folder);
  bool is_staged(const std::filesystem::path& temporary) const;

  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> staged_;
  std::vector<std::filesystem::path> new_folders_;
};

/// Removes frame-NNNN.png of an earlier run from `folder`, so that none is left over.
void remove_numbered_frames(const std::filesystem::path& folder);

}  // namespace timestep
