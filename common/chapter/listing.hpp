/// @file
/// What a chapter offers, for people and for programs: `--list` and `--list --json`.
#pragma once

#include <string>

#include "common/chapter/scene.hpp"

namespace timestep {

/// Scenes with methods, parameters (unit, default, range) and presets, and what there
/// is to do with files, 88 columns wide.
std::string list_text(const Chapter& chapter);

/// The same as JSON; each method with the colour, marker and dash of its plots.
std::string list_json(const Chapter& chapter);

}  // namespace timestep
