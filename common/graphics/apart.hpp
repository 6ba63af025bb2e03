/// @file
/// Work that may crash, done where a crash does no harm.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace timestep {

/// The bytes that `work` returns, computed in a process of its own that knows all that
/// this one knows. Nothing if that process crashes, or is ended because it takes longer
/// than `seconds` or 4 GiB of memory.
std::optional<std::string> compute_apart(const std::function<std::string()>& work,
                                         unsigned seconds);

}  // namespace timestep
