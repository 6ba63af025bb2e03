/// @file
/// The scenes of chapter 2, once for each precision.
#pragma once

#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/precision.hpp"

namespace timestep {
namespace single_precision::chapter_02 {
std::vector<Scene> scenes();
}
namespace double_precision::chapter_02 {
std::vector<Scene> scenes();
}
}  // namespace timestep
