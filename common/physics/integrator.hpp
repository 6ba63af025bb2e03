/// @file
/// The common form of every integrator: d coordinates x, their rates v, and a function
/// that answers with their accelerations. An integrator sees numbers, not particles.
/// Source: chapter 1; thesis, section 2.1.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "common/physics/real.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// d coordinates x [m], their rates v [m/s], and room for their accelerations a [m/s²].
/// All three have d elements; particles take three after each other (see particle.hpp).
struct State {
  std::vector<Real> x, v, a;
};

/// Writes a(x, v, t), the acceleration of every coordinate [m/s²] at time t [s].
using Acceleration = std::function<void(
    std::span<const Real> x, std::span<const Real> v, Real t, std::span<Real> a)>;

/// Moves a state from time t to t + dt [s].
using Integrator = void (*)(State& state, const Acceleration& acceleration, Real t,
                            Real dt);

/// An integrator as a user names it, with its price.
struct NamedIntegrator {
  std::string_view name;
  Integrator step;
  int evaluations;  ///< of the acceleration, in one step
};

}  // namespace timestep::inline TIMESTEP_PRECISION
