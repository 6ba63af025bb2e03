#include "common/chapter/console.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "common/graphics/input_error.hpp"

namespace timestep {

void print_out(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw InputError("cannot write to standard output");
  }
}

void print_note(const std::string& program, const std::string& text) {
  fmt::print(stderr, "{}: {}\n", program, text);
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_ >= 0) fmt::print(stderr, "\r      \r");
}

void Progress::show(double share) {
  const int percent = static_cast<int>(share * 100);
  if (!terminal_ || percent == shown_) return;
  if (std::chrono::steady_clock::now() - begin_ < std::chrono::seconds(1)) return;
  fmt::print(stderr, "\r{:3} % ", percent);
  std::fflush(stderr);
  shown_ = percent;
}

}  // namespace timestep
