/// @file
/// How far apart two convex shapes are, from their support functions alone. Source:
/// chapter 4; E. Gilbert, D. Johnson, S. Keerthi, A fast procedure for computing the
/// distance between complex objects in three-dimensional space, IEEE Journal of
/// Robotics and Automation 4(2), 1988; G. van den Bergen, Collision Detection in
/// Interactive 3D Environments, 2003, chapter 4.
#pragma once

#include "common/physics/separation.hpp"
#include "common/physics/simplex.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// What a query ended with: a start for the same pair's next query, when both have
/// moved a little. Its points stay on their shapes, wherever those go.
struct GjkCache {
  Simplex simplex;
};

/// (4.14) GJK between two of its steps: the simplex in the Minkowski difference of the
/// cores, its point v closest to the origin, and a lower bound of the distance, all in
/// the difference's units.
struct Gjk {
  Simplex simplex;
  Vec3 v;
  Vec3 normal{0, 0, 1};  ///< unit, from A to B: the one that proves the lower bound
  Real lower = -2;       ///< no plane between the shapes is wider
  int iterations = 0;
  Reason reason = Reason::converged;
  bool done = false;
};

/// Most steps. Polyhedra end after about ten, smooth shapes after about thirty.
constexpr int k_gjk_limit = 100;

/// From the simplex of the cache, if it holds one, or from one support point.
Gjk gjk_start(const MinkowskiDifference& difference, const GjkCache* cache);

/// (4.15) One step: the support point towards the origin, then the reduced simplex.
/// Done once the bounds are as close as rounding lets them be, the simplex holds the
/// origin, or v stops to come closer.
void gjk_step(const MinkowskiDifference& difference, Gjk& gjk);

/// All steps until the distance of the cores is known. Without a cache it starts
/// afresh; with one from there, and leaves there where it ended.
Gjk run_gjk(const MinkowskiDifference& difference, GjkCache* cache);

/// Whether GJK ended with a simplex that holds the origin or comes as close as rounding
/// can tell.
bool cores_meet(const Gjk& gjk);

}  // namespace timestep::inline TIMESTEP_PRECISION
