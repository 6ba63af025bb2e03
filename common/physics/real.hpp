/// @file
/// The numbers of the physics: `Real` (float or double) and vectors of it.
/// Source: chapter 1.
#pragma once

#include <glm/glm.hpp>

#include "common/physics/precision.hpp"

#if !defined(TIMESTEP_PRECISION)
#error "physics is compiled for one precision: link physics_single or physics_double"
#endif

namespace timestep::inline TIMESTEP_PRECISION {

#if defined(TIMESTEP_DOUBLE)
using Real = double;
#else
using Real = float;
#endif

using Vec3 = glm::vec<3, Real>;

}  // namespace timestep::inline TIMESTEP_PRECISION
