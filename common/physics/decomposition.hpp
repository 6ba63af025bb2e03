/// @file
/// A concave mesh as several convex parts, by cutting it along the axes. Source:
/// chapter 4; thesis, section 2.2.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct DecompositionSettings {
  int parts = 16;                ///< at most, at least 1
  int cuts_per_axis = 7;         ///< that are tried for each part, evenly spaced
  Real least_gain = Real(0.01);  ///< what a cut must save, in volumes of the whole hull
};

/// Convex parts that together cover the mesh and do not overlap: mesh_volume <=
/// parts_volume <= hull_volume, and parts_volume - mesh_volume is what they add to it.
struct Decomposition {
  std::vector<ConvexHull> parts;
  Real mesh_volume = 0, parts_volume = 0, hull_volume = 0;  ///< [m³]
  std::string fault;  ///< why there are no parts, see `mesh_fault`; empty if there are
};

/// (4.28) Begins with the hull of the whole mesh [m]. Then, again and again, cuts that
/// part in two which loses most volume by it: each half is as large as its own hull,
/// and a hull bridges fewer hollows the smaller its part is. Time grows with triangles
/// times parts.
Decomposition decompose(std::span<const Vec3> vertices,
                        std::span<const Triangle> triangles,
                        const DecompositionSettings& settings = {});

}  // namespace timestep::inline TIMESTEP_PRECISION
