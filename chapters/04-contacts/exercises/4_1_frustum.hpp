/// @file
/// Exercise 4.1, warm-up: A support function of your own
#pragma once

#include "common/physics/shapes.hpp"

namespace timestep {

/// A bucket without a hollow: a round frustum about the z axis, from a disc of radius
/// `lower` at z = 0 to a disc of radius `upper` at z = height. All in m; a radius may
/// be 0.
struct Frustum {
  Real lower, upper, height;
};

/// (4.2) A point of the frustum farthest in the direction, whose length does not
/// matter. In a tie any of the farthest points; of a zero direction any point of it.
Vec3 support(const Frustum& frustum, const Vec3& direction);

}  // namespace timestep
