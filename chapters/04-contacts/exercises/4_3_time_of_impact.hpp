/// @file
/// Exercise 4.3, core: When do they touch?
#pragma once

#include <optional>

#include "common/physics/epa.hpp"

namespace timestep {

/// A convex shape on its way: at the time t [s] it is at pose.position + t velocity. It
/// does not turn.
struct Moving {
  Convex shape;
  Pose pose;
  Vec3 velocity;  ///< [m/s]
};

/// The first time [s] from 0 to `until` at which two moving shapes are no further apart
/// than `within` [m], or nothing if they are further apart all the time. Where they are
/// that close it is no earlier than they would be 2 `within` apart. Asks the engine for
/// the separation 1,000 times at most.
std::optional<Real> time_of_impact(const Moving& a, const Moving& b, Real until,
                                   Real within);

}  // namespace timestep
