/// @file
/// The runs that truth cases ask for: a scheme, a system, and how far. Compiled for
/// each precision.
#pragma once

#include "common/physics/dormand_prince.hpp"
#include "common/physics/stability.hpp"
#include "common/physics/systems.hpp"
#include "tests/truth/fields.hpp"
#include "tests/truth/kind.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct Run {
  Scheme scheme;
  Acceleration acceleration;
  State start;
  Real dt;
  long long n;
};

/// The scheme that a case names in the truth's words. Throws NotCovered if there is
/// none.
Scheme scheme_of(const truth::Json& inputs);

Run constant_acceleration_run(const truth::Json& inputs);
Run oscillator_run(const truth::Json& inputs);
Run damped_oscillator_run(const truth::Json& inputs);
Run pendulum_run(const truth::Json& inputs);
Run kepler_run(const truth::Json& inputs);

/// A pendulum with g = length from theta0, omega0, in n steps to T.
Run convergence_run(const truth::Json& inputs, const Scheme& scheme, long long n);

DoublePendulum double_pendulum_of(const truth::Json& inputs);

/// Its start and its duration as one step; and the tolerance of its reference.
Run double_pendulum_run(const truth::Json& inputs);
Tolerance double_pendulum_tolerance();

/// Where a run stands after all its steps.
Integration end_of(const Run& run);

/// What an oscillator's run keeps, by the matrix of a step in units of v / omega.
truth::Json invariant_fields(const truth::Json& inputs, const Scheme& scheme,
                             const StepMatrix& m);

/// A state that holds a place, and the place in a state.
State state_of(const truth::Place& place);
truth::Place place_of(const State& state);

}  // namespace timestep::inline TIMESTEP_PRECISION
