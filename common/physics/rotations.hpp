/// @file
/// Every method of chapter 3 by its name. Source: chapter 3.
#pragma once

#include <span>
#include <string_view>

#include "common/physics/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// In the chapter's order.
std::span<const RotationMethod> rotation_methods();

/// Null if there is none of that name.
const RotationMethod* find_rotation_method(std::string_view name);

}  // namespace timestep::inline TIMESTEP_PRECISION
