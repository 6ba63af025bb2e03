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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const bool ignored = std::signal(signal, note_signal) == SIG_IGN;  // as by nohup
    if (ignored) std::signal(signal, SIG_IGN);
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void throw_if_interrupted() {
  if (g_interrupted != 0) throw Interrupted();
}

}  // namespace timestep
