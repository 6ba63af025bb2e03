#include <cstdlib>

#include "common/graphics/resource_manager.hpp"

namespace timestep {
namespace {

/// Where the folder of assets may be, the likeliest first.
std::vector<std::filesystem::path> asset_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* chosen = std::getenv("TIMESTEP_ASSETS")) folders.emplace_back(chosen);
  folders.emplace_back(TIMESTEP_ASSETS);

  // Beside the executable, or up to three folders above it
  std::error_code unknown;
  auto folder = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (int i = 0; i < 4 && !unknown; ++i, folder = folder.parent_path()) {
    folders.push_back(folder / "assets");
  }
  return folders;
}

}  // namespace

std::filesystem::path find_asset(const std::string& kind,
                                 const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) return file;
  for (const std::filesystem::path& folder : asset_folders()) {
    const std::filesystem::path candidate = folder / kind / file;
    if (std::filesystem::is_regular_file(candidate, ignored)) return candidate;
  }
  return file;
}

}  // namespace timestep
