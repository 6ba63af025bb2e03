/// @file
/// Ways to move the bodies of a world over a step, on one form. Source: chapter 6.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "common/physics/contact_rows.hpp"
#include "common/physics/impulse.hpp"
#include "common/physics/penetration.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// A step of dt [s]: its bodies with their contacts as they are at its start.
struct SolverStep {
  std::span<RigidBody> bodies;
  std::span<PointContact> contacts;
  const SolverSettings& settings;
  const PenetrationMethod& out_of_penetration;
  const PenetrationSettings& penetration;
  const ImpactLaw& impact_law;
  Real dt;
  SolverRoom& room;
  PenetrationRoom& penetration_room;
};

/// (6.9), (6.10) The thesis's: penetrations first, then impacts one by one, the fastest
/// first, each by the impact law.
void worst_first(const SolverStep& step);

/// (6.11) Gauss-Seidel on all velocities, with accumulated impulses that start from
/// those of the step before.
void sequential_impulses(const SolverStep& step);

/// (6.13) Several short steps with one sweep each and one to relax, contacts being
/// soft. Penetrations need no way out of their own.
void substeps(const SolverStep& step);

/// (6.14) All velocities at once, by Lemke's method: for a few contacts. Friction's
/// circle is a polygon; sweeps then round it off.
void direct(const SolverStep& step);

/// A solver by its name.
struct Solver {
  std::string_view name, summary;
  void (*advance)(const SolverStep& step);
};
std::span<const Solver> solvers();

/// Null if there is none of that name.
const Solver* find_solver(std::string_view name);

}  // namespace timestep::inline TIMESTEP_PRECISION
