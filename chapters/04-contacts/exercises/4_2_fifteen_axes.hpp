/// @file
/// Exercise 4.2, core: Fifteen axes
#pragma once

#include "common/physics/separation.hpp"
#include "common/physics/shapes.hpp"

namespace timestep {

/// How far [m] two boxes overlap along a direction of length one, or, negative, how
/// wide the gap is: by how much B has to move along `n` to touch A from the other side.
Real overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b,
             const Vec3& n);

/// The penetration depth [m] of two boxes: the least overlap along any direction. If
/// there is a gap along one of those that matter, the answer is negative, and how
/// wide the gap is does not matter.
Real penetration_depth(const Box& a, const Pose& pose_a, const Box& b,
                       const Pose& pose_b);

}  // namespace timestep
