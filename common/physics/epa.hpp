/// @file
/// How deep two convex shapes are in each other, from their support functions alone,
/// and the whole query: GJK where their cores are apart, EPA where they meet. Source:
/// chapter 4; G. van den Bergen, Proximity queries and penetration depth computation on
/// 3D game objects, Game Developers Conference 2001.
#pragma once

#include "common/physics/gjk.hpp"
#include "common/physics/polytope.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// (4.18) EPA between two of its steps. `depth` [units] is how far B has to move
/// against `outward` to come free, the least found so far; `face` has the vertices of
/// the face with this normal. It was measured, not estimated, so it is enough whatever
/// happens.
struct Epa {
  Polytope polytope;
  Vec3 outward{0, 0, 1};
  Real depth = 2;
  std::array<std::int16_t, 3> face{};
  Real stuck = 2;   ///< least offset of a face that rounding keeps from growing
  Real lower = -2;  ///< least offset of all faces: the depth is at least this
  int iterations = 0;
  Reason reason = Reason::converged;
  bool done = false;
};

/// Most steps. Two hulls of a thousand vertices take about fifty; smooth shapes whose
/// depth is nearly the same all around may use them up and be off by some 1e-4 of their
/// size.
constexpr int k_epa_limit = 2 * k_polytope_vertices;

/// A tetrahedron around the simplex that GJK ended with. Where the difference is flat
/// (up to rounding), that is all: done, with the normal of its plane.
void epa_start(const MinkowskiDifference& difference, const Simplex& simplex, Epa& epa);

/// (4.19) One step: the support point behind the face closest to the origin, and the
/// hull of the polytope and that point. Done once nothing is farther out than that
/// face.
void epa_step(const MinkowskiDifference& difference, Epa& epa);

/// The signed distance of two shapes, of their cores first: the radii change neither
/// the normal nor the side on which the witness points are. No answer is NaN for finite
/// input, and no query allocates or takes more than k_gjk_limit + k_epa_limit steps.
Separation separation(const Convex& a, const Pose& pose_a, const Convex& b,
                      const Pose& pose_b, GjkCache* cache = nullptr);

/// Whether two shapes have a point in common, up to rounding: as soon as that is known,
/// without their distance. Of needles, for which GJK's simplices are slivers, up to
/// 1e-9 of their size, or in single precision 1e-4.
bool intersect(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b,
               GjkCache* cache = nullptr);

}  // namespace timestep::inline TIMESTEP_PRECISION
