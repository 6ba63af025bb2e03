/// @file
/// Runs whose rounding is smaller than that of their places: to see errors that are
/// smaller, too. Every step is taken in a frame that starts with the body and moves
/// with it, where a scheme works on increments alone. Compiled for each precision.
#pragma once

#include "tests/truth/runs.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Where a run ends: x and v, and what the scheme keeps in their place.
struct FineEnd {
  truth::FinePlace now, kept;
};

/// The end of a run of a system without explicit time.
FineEnd fine_end_of(const Run& run);

}  // namespace timestep::inline TIMESTEP_PRECISION

namespace timestep::double_precision {

/// Where the pendulum of a convergence case ends, to more digits than a double has: by
/// a fifth-order method with so many steps that its error is small beside any on the
/// ladder.
truth::FinePlace convergence_reference(const truth::Json& inputs);

}  // namespace timestep::double_precision
