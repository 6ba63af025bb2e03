/// @file
/// Every method of chapters 1 and 2 on the one form of a scheme. Source: chapter 2.
#pragma once

#include "common/physics/scheme.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// All of them, in the order of the chapter.
std::span<const Scheme> schemes();

/// Those for forces that depend on the velocity: see verlet_drag.hpp.
std::span<const Scheme> drag_schemes();

/// The scheme of that name among both, or null.
const Scheme* find_scheme(std::string_view name);

}  // namespace timestep::inline TIMESTEP_PRECISION
