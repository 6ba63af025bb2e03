/// @file
/// The thesis's main loop (Listing 1) made safe: real time goes in, whole steps come
/// out. It reads no clock, so that a window, a recording and a test can all drive it.
#pragma once

namespace timestep {

/// Turns frame times of any length into steps of one length.
///
/// Frame time is gathered in `accumulator` and paid out in whole steps. A step counts
/// as complete when all but a billionth of it has been gathered: the sum of a few dozen
/// rounded frame times is off by less than 1e-14 of a step, so three frames of dt/3
/// make one step, never none. What such a step borrowed stays in the accumulator as a
/// tiny debt, so nothing drifts: after any number of frames steps * dt + accumulator +
/// dropped is the sum of all frame times.
struct FixedStep {
  double dt = 1.0 / 60.0;       ///< length of a step [s], greater than 0
  int max_steps_per_frame = 8;  ///< so that a slow frame cannot cause slower ones
  double accumulator = 0;       ///< time gathered but not yet simulated [s]
  double dropped = 0;           ///< time given up because of the cap [s]

  /// Takes the last frame's length [s] and says how many steps to do now. A frame time
  /// that is negative or not finite (a clock set back, a debugger's pause) counts as 0.
  int advance(double frame_time);

  /// How far the picture stands between the previous step (0) and the current one (1).
  double alpha() const;
};

}  // namespace timestep
