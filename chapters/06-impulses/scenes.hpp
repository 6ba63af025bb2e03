/// @file
/// The scenes of chapter 6, in both precisions.
#pragma once

#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::chapter_06 {
std::vector<Scene> scenes();
}
namespace double_precision::chapter_06 {
std::vector<Scene> scenes();
}
}  // namespace timestep
