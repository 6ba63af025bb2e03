/// @file
/// Exercise 7.2, core: Two runs tell the third
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// A run with steps of dt [s], and its error in any unit.
struct Trial {
  Real dt, error;
};

/// (7.1): error = constant dt^order. `constant` is the error of steps of a second.
struct Convergence {
  Real order, constant;
};

/// What two runs of different steps, each with an error above 0, say of a method.
Convergence convergence(const Trial& a, const Trial& b);

/// The longest step [s] that (7.1) allows for this error, which is above 0; 0 if
/// shorter steps do not help, that is, if the order is not above 0.
Real step_for(const Convergence& c, Real error);

}  // namespace timestep
