/// @file
/// A cell as a reader takes it home: as a command, and as code.
#pragma once

#include <string>
#include <vector>

#include "study/cell.hpp"

namespace timestep::study {

/// The command of the chapter's executable that runs the cell, from the repository's
/// root, and prints its numbers.
std::string command_of(const Cell& cell);

/// C++ against common/physics that does what the cell does, a line each; the library to
/// link is named in its first line.
std::vector<std::string> code_of(const Cell& cell);

}  // namespace timestep::study
