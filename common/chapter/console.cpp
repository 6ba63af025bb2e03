#include "common/chapter/console.hpp"

#include <algorithm>
#include <cstdio>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "common/graphics/input_error.hpp"

namespace timestep {

void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const int wrong_way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", wrong_way);
  }
}

void print_out(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw InputError("cannot write to standard output");
  }
}

void print_note(const std::string& program, const std::string& text) {
  std::string line = program + ": " + text;
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  std::ranges::replace_if(line, is_control, '?');
  std::fputs((line + "\n").c_str(), stderr);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_ >= 0) std::fputs("\r      \r", stderr);
}

void Progress::show(double share) {
  const int percent = static_cast<int>(share * 100);
  if (!terminal_ || percent == shown_) return;
  if (std::chrono::steady_clock::now() - begin_ < std::chrono::seconds(1)) return;
  std::fputs(fmt::format("\r{:3} % ", percent).c_str(), stderr);
  std::fflush(stderr);
  shown_ = percent;
}

}  // namespace timestep
