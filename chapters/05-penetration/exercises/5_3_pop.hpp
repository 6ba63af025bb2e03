/// @file
/// Exercise 5.3, core: How far does it pop?
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// A column of equal bodies at rest, one over the other. Each is `depth` [m] in the one
/// below, and the lowest in the floor. Baumgarte's velocities (5.4), of which each
/// contact gets all that it asks for, no more, are theirs to keep.
struct Column {
  int bodies;
  Real mass;         ///< [kg] of each
  Real depth, slop;  ///< [m]
  Real beta, dt;     ///< [1], [s]
};

/// The speed [m/s] of body `number` from below, counted from 1.
Real speed_of(const Column& column, int number);

/// The energy [J] that has been put in.
Real energy_put_in(const Column& column);

/// How high [m] over its start the top body gets, if it meets nobody, under a
/// `gravity` [m/s²].
Real rise(const Column& column, Real gravity);

}  // namespace timestep
