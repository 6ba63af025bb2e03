/// @file
/// The scenes of chapter 7, in both precisions.
#pragma once

#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::chapter_07 {
std::vector<Scene> scenes();
}
namespace double_precision::chapter_07 {
std::vector<Scene> scenes();
}
}  // namespace timestep
