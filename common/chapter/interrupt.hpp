/// @file
/// Ctrl+C without debris: the signal is noted, the run ends at its next step by an
/// exception, and whatever was half written is taken back on the way out.
#pragma once

#include <exception>

namespace timestep {

/// Thrown after Ctrl+C or a request to terminate.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// From now on the first SIGINT, SIGTERM or SIGHUP is only noted; a second one ends the
/// program as usual; one that the caller wants ignored stays so. Writing into a closed
/// pipe, or more than a file may hold, becomes an error instead of a signal.
void note_interrupts();

/// Throws Interrupted if such a signal has come.
void throw_if_interrupted();

}  // namespace timestep
