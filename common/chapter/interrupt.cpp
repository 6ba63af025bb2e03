#include "common/chapter/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace timestep {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

extern "C" void note_signal(int signal) {
  g_interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void note_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, note_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

void throw_if_interrupted() {
  if (g_interrupted != 0) throw Interrupted();
}

}  // namespace timestep
