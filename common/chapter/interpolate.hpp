/// @file
/// Pictures between two steps, so that motion is smooth at any display rate.
#pragma once

#include "common/graphics/draw_list.hpp"

namespace timestep {

/// The picture at `alpha` between the previous step (0) and the current one (1): places
/// are interpolated linearly, rotations along the shortest arc (slerp). Lists of
/// unequal length cannot be paired: those stay as they were in the previous step,
/// except that a line which grew by new points at its end grows smoothly. Words are the
/// previous step's, too, until alpha reaches 1.
DrawList interpolate(const DrawList& previous, const DrawList& current, float alpha);

/// The transform between two: translation and scale linear, rotation by slerp. Flat or
/// mirrored ones, which have no rotation of their own, are interpolated by element.
glm::mat4 interpolate(const glm::mat4& previous, const glm::mat4& current, float alpha);

}  // namespace timestep
