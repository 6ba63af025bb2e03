/// @file
/// Exercise 1.3, core: A clock that keeps what rounding takes
#pragma once

namespace timestep {

/// A clock in single precision for frames of any length.
struct Clock {
  float time = 0;  ///< what it shows [s]
  float lost = 0;  ///< what rounding has taken and not yet been given back [s]
};

/// Lets a frame of `frame_time` [s] pass.
void tick(Clock& clock, float frame_time);

}  // namespace timestep
