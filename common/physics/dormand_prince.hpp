/// @file
/// Dormand and Prince's method with a step that it chooses itself: the reference where
/// no closed form is known. Source: chapter 2; J. R. Dormand, P. J. Prince, A family of
/// embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19.
#pragma once

#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// What one step may do wrong: absolute + relative |x| in every x, the same in every v
/// (in their units); and after how many steps to give up.
struct Tolerance {
  Real relative, absolute;
  long long most_steps = 100'000;
};

/// What it took.
struct AdaptiveCost {
  long long accepted = 0, rejected = 0, evaluations = 0;
};

/// Moves a state from time t to t_end [s], t_end > t. Equation (2.21): the difference
/// to a fourth-order result from the same looks estimates the error, and the step
/// follows it. Where even the smallest step misses the tolerance, or there would be too
/// many, x and v become NaN.
AdaptiveCost dormand_prince(State& state, const Acceleration& acceleration, Real t,
                            Real t_end, const Tolerance& tolerance);

}  // namespace timestep::inline TIMESTEP_PRECISION
