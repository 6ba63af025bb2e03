/// @file
/// The window: a scene running in real time under a panel that changes it.
#pragma once

#include "common/chapter/options.hpp"
#include "common/chapter/scene.hpp"

namespace timestep {

/// Opens the window and runs until it is closed. Throws InputError if there is no
/// display or the options ask for something that the chapter does not have.
void run_window(const Chapter& chapter, const Options& options);

}  // namespace timestep
