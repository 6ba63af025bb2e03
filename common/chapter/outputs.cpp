#include "common/chapter/outputs.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& option, const fs::path& path,
                         const std::string& why) {
  throw InputError(fmt::format("{} {}: {}", option, path.string(), why));
}

/// The file that a link leads to, so that the link survives the renaming.
fs::path behind_links(const fs::path& target) {
  std::error_code ignored;
  const fs::path real = fs::canonical(target, ignored);
  return real.empty() ? target : real;
}

}  // namespace

Outputs::~Outputs() {
  std::error_code ignored;
  for (const auto& [temporary, target] : staged_) fs::remove(temporary, ignored);
  std::ranges::reverse(new_folders_);  // the innermost first
  for (const fs::path& folder : new_folders_) {
    fs::remove(folder, ignored);  // only if it is empty
  }
}

void Outputs::make_folder(const std::string& option, const fs::path& folder) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return;
  if (fs::exists(folder, error)) refuse(option, folder, "is a file, not a folder");

  make_folder(option, folder.parent_path());
  const bool made = fs::create_directory(folder, error);
  if (error) refuse(option, folder, "cannot make the folder: " + error.message());
  if (made) new_folders_.push_back(folder);
}

bool Outputs::is_staged(const fs::path& temporary) const {
  std::error_code ignored;
  return fs::exists(temporary, ignored)  // if not, none needs to be compared
         && std::ranges::any_of(staged_, [&](const auto& pair) {
              return fs::equivalent(pair.first, temporary, ignored);
            });
}

fs::path Outputs::stage(const std::string& option, const fs::path& target) {
  const fs::path place = behind_links(target);
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) refuse(option, place, "is a folder");
  if (!place.has_filename()) refuse(option, place, "names no file");
  if (fs::exists(place, ignored) && !fs::is_regular_file(place, ignored)) return place;
  if (fs::is_symlink(place, ignored)) refuse(option, place, "is a link to nowhere");

  make_folder(option, place.parent_path());
  const fs::path temporary =
      place.parent_path()
      / fmt::format(".partial-{}-{}", getpid(), place.filename().string());
  if (is_staged(temporary)) refuse(option, place, "is another file of this run");
  errno = 0;
  if (!std::ofstream(temporary, std::ios::binary)) {
    refuse(option, place, fmt::format("cannot be written: {}", std::strerror(errno)));
  }
  staged_.emplace_back(temporary, place);
  return temporary;
}

void Outputs::discard(const fs::path& temporary) {
  std::error_code ignored;
  fs::remove(temporary, ignored);
  std::erase_if(staged_, [&](const auto& pair) { return pair.first == temporary; });
}

void Outputs::publish() {
  for (const auto& [temporary, target] : staged_) {
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error) throw InputError(target.string() + ": " + error.message());
  }
  staged_.clear();
  new_folders_.clear();
}

void remove_numbered_frames(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string file = entry.path().filename().string();
    const bool numbered = file.size() == 14 && file.starts_with("frame-")
                          && file.ends_with(".png")
                          && std::all_of(file.begin() + 6, file.begin() + 10,
                                         [](char c) { return c >= '0' && c <= '9'; });
    if (numbered) fs::remove(entry.path(), ignored);
  }
}

}  // namespace timestep
