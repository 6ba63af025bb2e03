/// @file
/// Exercise 2.1, warm-up: Formula 3 as the thesis has it
#pragma once

#include "common/physics/integrator.hpp"

namespace timestep {

/// Velocity Verlet from time t to t + dt [s], with x += v dt + a_n dt²/2 and v += (a_n
/// + a_{n+1}) dt/2. Takes state.a at t as the last step left it, and leaves it at t +
/// dt. The forces depend on x and t alone.
void formula_3(State& state, const Acceleration& acceleration, Real t, Real dt);

}  // namespace timestep
