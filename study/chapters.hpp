/// @file
/// The chapters whose scenes are studied, as their executables have them.
#pragma once

#include "common/chapter/scene.hpp"
#include "study/problem.hpp"

namespace timestep::study {

/// Chapter 1 to 6. Throws std::out_of_range for another name.
const Chapter& chapter_named(const std::string& name);

/// A problem's scene, in double precision. Throws std::out_of_range if it has none.
const Scene& scene_of(const Problem& problem);

}  // namespace timestep::study
