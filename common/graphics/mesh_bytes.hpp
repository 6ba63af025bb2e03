/// @file
/// Parts of a mesh as bytes, to hand them from one process to another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/graphics/mesh_parts.hpp"

namespace timestep {

/// All that the parts hold; to be read back by the same program on the same machine.
std::string to_bytes(const std::vector<MeshPart>& parts);

/// What `to_bytes` was given.
std::vector<MeshPart> parts_from_bytes(std::string_view bytes);

}  // namespace timestep
