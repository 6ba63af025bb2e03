#include "common/chapter/fixed_step.hpp"

#include <algorithm>
#include <cmath>

namespace timestep {
namespace {

constexpr double k_tolerance = 1e-9;  // of a step; see the header

}  // namespace

int FixedStep::advance(double frame_time) {
  if (!(dt > 0) || !std::isfinite(dt)) return 0;
  if (std::isfinite(frame_time) && frame_time > 0) accumulator += frame_time;

  // Split into whole steps and a rest; fmod is exact, however long the frame was
  double rest = std::fmod(accumulator, dt);
  if (rest >= dt * (1 - k_tolerance)) rest -= dt;
  const double whole = std::round((accumulator - rest) / dt);
  accumulator = rest;

  // Give up what does not fit in a frame, rather than fall behind for ever
  const double steps = std::clamp(whole, 0.0, static_cast<double>(max_steps_per_frame));
  dropped += (whole - steps) * dt;
  return static_cast<int>(steps);
}

double FixedStep::alpha() const {
  return std::clamp(accumulator / dt, 0.0, 1.0);
}

}  // namespace timestep
