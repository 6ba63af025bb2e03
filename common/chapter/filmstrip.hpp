/// @file
/// Pictures put side by side.
#pragma once

#include <span>

#include "common/graphics/image.hpp"

namespace timestep {

/// Pictures of equal size from left to right, with a light gap between them.
Image side_by_side(std::span<const Image> images);

}  // namespace timestep
