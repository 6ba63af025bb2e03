/// @file
/// What to answer to a name that does not exist: the names that it may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace timestep {

/// Fewest letters to insert, delete, replace or swap with their neighbour that turn one
/// word into the other (optimal string alignment).
int edit_distance(std::string_view a, std::string_view b);

/// At most three of `names` that are close to `wrong` or contain it, the nearest first.
std::vector<std::string> nearest_names(std::string_view wrong,
                                       std::span<const std::string> names);

/// The line for an unknown name: `unknown scene "sprin"; did you mean spring?`, or the
/// whole choice when no name is near.
std::string unknown_name(std::string_view kind, std::string_view wrong,
                         std::span<const std::string> names);

}  // namespace timestep
