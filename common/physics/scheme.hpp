/// @file
/// The common form of the methods of chapter 2. Some keep more than x and v from step
/// to step, some work in stages; a scheme says how much room it needs, how it starts,
/// and how x and v are read from what it keeps. Source: chapter 2.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/physics/integrator.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Writes the acceleration of a state where it stands, at time t [s]. Methods that call
/// this are written for any state of x, v and a: for the State of a whole system, and
/// for one Particle that is on its own (swarm.hpp), which then stays in registers.
inline void evaluate(auto& state, const auto& acceleration, Real t) {
  acceleration(std::span<const Real>(state.x), std::span<const Real>(state.v), t,
               std::span<Real>(state.a));
}

/// The states that a method needs beside the one that it changes, of the same kind.
template <typename S>
using Stages = std::span<std::type_identity_t<S>>;

/// Changes a state, using the room of `stages`, from time t to t + dt [s] (a step) or
/// at the time t (start and read).
using StagedStep = void (*)(State& state, std::span<State> stages,
                            const Acceleration& acceleration, Real t, Real dt);

/// A method with its price and its character.
struct Scheme {
  std::string_view name, summary;
  StagedStep step;
  int evaluations;  ///< of the acceleration, in one step; 0: as many as a solver needs
  int order;        ///< p: the error after a fixed time shrinks as dt^p
  bool symplectic = false;     ///< keeps areas of phase space
  bool reversible = false;     ///< a step back with -dt undoes a step
  std::size_t stages = 0;      ///< states that it needs beside the current one
  StagedStep start = nullptr;  ///< from x, v at t to what the scheme keeps, if more
  StagedStep read = nullptr;   ///< from what the scheme keeps to x, v at t, if other
};

/// A scheme at work on one system.
struct Integration {
  Scheme scheme;
  Acceleration acceleration;
  Real dt;  ///< [s]
  State state;
  std::vector<State> stages;
  long long steps = 0;  ///< taken so far
};

/// Takes up a system at time 0 in the state given.
Integration begin(const Scheme& scheme, const Acceleration& acceleration,
                  const State& start, Real dt);

/// Takes one step.
void advance(Integration& integration);

/// x, v at the time steps dt, whatever the scheme keeps. Costs an evaluation where the
/// scheme keeps something else (see Scheme::read), and leaves the integration alone.
State read(const Integration& integration);

}  // namespace timestep::inline TIMESTEP_PRECISION
