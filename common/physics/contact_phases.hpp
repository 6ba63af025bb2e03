/// @file
/// What contacts do within a substep, and when: impacts act at the moment when the pair
/// closes, so that a bounce loses and gains nothing but what its restitution says. A
/// body that bounces again before the next step does so on contacts as they were found
/// for its first way: it may pass through a part of what it meets on its second.
/// Source: chapter 6.
#pragma once

#include <span>

#include "common/physics/contact_rows.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (6.13) How the contacts stand at the start of a substep of h [s], and so which
/// velocity each asks for at its end, and when its impulse acts. Returns whether
/// something bounces.
bool look_ahead(SolverRoom& room, const SolverSettings& settings,
                const SoftCoefficients& soft, Real h);

/// (6.13) What bounced has done so; what then closes within the substep, pushed by it,
/// bounces next. Returns whether something does.
bool bounce_on(SolverRoom& room, const SolverSettings& settings, Real h);

/// (6.13) From now on contacts that last ask for no more than that nothing closes: the
/// velocity that pushed penetrating bodies apart is taken out again.
void relax(std::span<ContactRow> rows);

/// Impulses that acted at a time of their own moved the bodies for the rest of the
/// substep only. `move` had them act in the middle. Then the substep is over.
void correct_for_time(SolverRoom& room, Real h);

}  // namespace timestep::inline TIMESTEP_PRECISION
