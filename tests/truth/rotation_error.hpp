/// @file
/// What single precision may do to a turning body, bounded by a run in double as
/// single_error.hpp does it for x and v: here for the four numbers of q and the three
/// of omega.
#pragma once

#include "tests/truth/rotation_runs.hpp"
#include "tests/truth/single_error.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A run in double, followed step by step, and where the same run in single precision
/// may be. Throws truth::NotCovered where that leaves the range of a float.
class FollowedRotation {
 public:
  explicit FollowedRotation(const RotationRun& run);

  void step();
  truth::Place at() const;
  Ellipsoid error() const;

 private:
  // What may be rounded in one step: of each number of q, and of omega
  struct Rounding {
    double q;
    glm::dvec3 omega;
  };

  void add_rounding();
  Rounding rounding() const;

  RotationRun run_;
  Rotation now_;
  Matrix sum_, half_;
  Rounding before_{};  // at the start of the step
  double roundings_ = 0;
};

}  // namespace timestep::inline TIMESTEP_PRECISION
