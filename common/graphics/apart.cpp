#include "common/graphics/apart.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace timestep {
namespace {

/// Lets this process have only so much memory more than it has now. Where the system
/// does not tell how much that is, nothing is limited.
void limit_memory() {
  constexpr rlim_t k_more = rlim_t{4} << 30U;  // [B]
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  if (pages == 0) return;
  const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + k_more;
  const rlimit limit{.rlim_cur = most, .rlim_max = most};
  setrlimit(RLIMIT_AS, &limit);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 65536> piece{};
  for (;;) {
    const ssize_t count = read(file, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  }
}

/// The life of the other process: silent, bounded, and gone without any cleaning up,
/// which is for the first one to do.
[[noreturn]] void work_and_exit(const std::function<std::string()>& work, int output,
                                unsigned seconds) {
  dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) {
    std::signal(signal, SIG_DFL);
  }
  alarm(seconds);
  limit_memory();
  try {
    _exit(write_all(output, work()) ? 0 : 1);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

std::optional<std::string> compute_apart(const std::function<std::string()>& work,
                                         unsigned seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return std::nullopt;
  const pid_t process = fork();
  if (process == 0) work_and_exit(work, ends[1], seconds);
  close(ends[1]);
  std::string bytes = read_all(ends[0]);
  close(ends[0]);

  int status = -1;
  while (process > 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (process < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return std::nullopt;
  return bytes;
}

}  // namespace timestep
