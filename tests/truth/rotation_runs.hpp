/// @file
/// The turning bodies that truth cases ask for: a method, a body without torque, and
/// how far. Compiled for each precision.
#pragma once

#include "common/physics/rotation.hpp"
#include "tests/truth/fields.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct RotationRun {
  RotationMethod method;
  Vec3 I;
  Rotation start;
  Real dt;
  long long n;
};

/// The method that a case names in the truth's words. Throws NotCovered if there is
/// none.
RotationMethod rotation_method_of(const truth::Json& inputs);

RotationRun rotation_run(const truth::Json& inputs);

/// In n steps to T.
RotationRun rotation_order_run(const truth::Json& inputs, long long n);

/// With the world's angular velocity that stays, in one step to t.
RotationRun listing3_run(const truth::Json& inputs);

/// The angular velocity alone, by a scheme for the gyroscopic term.
RotationRun gyro_run(const truth::Json& inputs);

/// The orientation alone, by (3.4).
RotationRun quaternion_drift_run(const truth::Json& inputs);

/// A step without torque. Throws NotCovered where the method throws Unsolved.
void advance(const RotationRun& run, Rotation& r);

/// Where a run stands after all its steps.
Rotation end_of(const RotationRun& run);

/// q as x, omega as v; and back.
truth::Place place_of(const Rotation& r);
Rotation rotation_of(const truth::Place& place);

}  // namespace timestep::inline TIMESTEP_PRECISION
