#include "common/chapter/movie.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace timestep {
namespace {

std::vector<std::string> encoder_arguments(const std::filesystem::path& file,
                                           glm::ivec2 size, int fps) {
  return {"ffmpeg",
          "-loglevel",
          "quiet",
          "-y",
          "-f",
          "rawvideo",
          "-pixel_format",
          "rgba",
          "-video_size",
          fmt::format("{}x{}", size.x, size.y),
          "-framerate",
          std::to_string(fps),
          "-i",
          "pipe:0",
          "-vf",
          "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p",
          "-c:v",
          "libx264",
          "-preset",
          "veryfast",
          "-crf",
          "20",
          "-movflags",
          "+faststart",
          "-f",
          "mp4",
          "file:" + file.string()};
}

/// Starts a program that reads from `input` and is silent; -1 if that fails.
pid_t spawn(const std::filesystem::path& program, std::vector<std::string> arguments,
            int input) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = -1;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr,
                                pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? process : -1;
}

bool write_all(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    std::error_code ignored;
    const bool regular = std::filesystem::is_regular_file(file, ignored);
    if (regular && access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

Movie::Movie(const std::filesystem::path& ffmpeg, const std::filesystem::path& file,
             glm::ivec2 size, int fps)
    : file_(file) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return;
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);

  process_ = spawn(ffmpeg, encoder_arguments(file, size, fps), ends[0]);
  close(ends[0]);
  pipe_ = ends[1];
}

Movie::~Movie() {
  finish();
}

void Movie::add(const Image& image) {
  if (process_ > 0 && !broken_) broken_ = !write_all(pipe_, image.rgba);
}

std::optional<std::string> Movie::finish() {
  if (pipe_ >= 0) close(std::exchange(pipe_, -1));
  if (process_ <= 0) return "ffmpeg could not be started";

  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFEXITED(status)) return "ffmpeg was ended by a signal";
  if (WEXITSTATUS(status) != 0 || broken_) {
    return fmt::format("ffmpeg ended with {}", WEXITSTATUS(status));
  }
  std::error_code unknown;
  const bool empty = std::filesystem::file_size(file_, unknown) == 0;
  return empty ? std::optional<std::string>("ffmpeg wrote nothing") : std::nullopt;
}

}  // namespace timestep
