/// @file
/// JSON files from the user's hands.
#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

namespace timestep {

/// What is in a file. Throws InputError, in one line that names the file, if it is not
/// a regular file that can be read, is not JSON as the standard has it (which knows no
/// NaN), holds a number beyond the range of double, is nested deeper than 32 levels, or
/// names a field of an object twice.
nlohmann::json load_json(const std::filesystem::path& file);

}  // namespace timestep
