/// @file
/// The one way to refuse bad input: a single line that says what is wrong and where.
#pragma once

#include <stdexcept>

namespace timestep {

/// Thrown for anything that the user can mend: an option, a value, a file, a folder, a
/// display. `what()` is one line; a program prints it after its name and exits with 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace timestep
