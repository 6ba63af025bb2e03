/// @file
/// All contacts of a small scene at once, as a linear complementarity problem, solved
/// directly: the reference for solvers that iterate. Source: chapter 6; D. E. Stewart,
/// J. C. Trinkle, An implicit time-stepping scheme for rigid body dynamics with
/// inelastic collisions and Coulomb friction, 1996; R. W. Cottle, J. Pang, R. E. Stone,
/// The Linear Complementarity Problem, 1992, section 4.4.
#pragma once

#include <span>
#include <vector>

#include "common/physics/contact_rows.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (6.14) Find z >= 0 with w = M z + q >= 0 and w · z = 0: each unknown is 0 or its row
/// is. M is square, row by row. Always in double: its pivots cost digits.
struct LinearComplementarity {
  std::vector<double> M, q;
};

/// (6.14) By Lemke's method, in at most `limit` pivots. Empty if there is no solution,
/// or none was found.
std::vector<double> lemke(const LinearComplementarity& problem, int limit);

/// Directions into which the problem splits friction at a contact: corners of the
/// polygon that stands for the circle of Coulomb's law.
inline constexpr int k_friction_directions = 8;

/// (6.14) The problem of all rows: that each parts at its target at least, with an
/// impulse that does not pull, and that friction resists slip as strongly as it may.
LinearComplementarity contact_problem(const SolverRoom& room);

/// Gives the rows the impulses that solve their problem, and the bodies what those do.
/// False, with nothing changed, if no solution was found. Takes its room from the heap
/// anew each time, which nothing else in a settled step does.
bool solve_directly(SolverRoom& room);

}  // namespace timestep::inline TIMESTEP_PRECISION
