/// @file
/// Pairs of convex shapes from a JSON file.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

/// A shape where it is in the world, with what the shape refers to.
struct PlacedShape {
  Shape shape;
  Pose pose;
  std::vector<Vec3> points;  ///< of a polyhedron, about its first vertex [m]
  std::unique_ptr<const ConvexHull> hull;  ///< theirs; none if they are flat
};

struct PlacedPair {
  PlacedShape a, b;
};

/// A capsule from p to q [m].
PlacedShape placed_capsule(const glm::dvec3& p, const glm::dvec3& q, double radius);

/// The shapes A and B of a case's inputs [m]. What stands in the file in double is
/// rounded to Real once, vertices after the first of them is subtracted.
///
/// A convex_pair has polyhedra: a list `vertices` of at least one; `faces` (indices)
/// and `dimension` may stand there, too. In a shape_pair each has a `type`: box (full
/// `size`, `R`, `t`), sphere (`r`, `t`), cylinder (`r`, full height `h`, `axis` x, y or
/// z, `R`, `t`), capsule (from `p` to `q`, `r`), hull or triangle (`points`), point
/// (`t`). `t` is where its centre is, `R` world from body, row by row; left out, it is
/// not turned.
///
/// Throws InputError that begins with the field and says what is wrong with it: is
/// missing, is no number, is negative where it is a size, or is no rotation (R Rᵀ is
/// off by more than 1e-6, or mirrors).
PlacedPair read_pair(const std::string& kind, const nlohmann::json& inputs);

struct PairCase {
  std::string id;
  PlacedPair pair;
};

/// All cases of a file {"cases": [{"id", "kind", "inputs": {"A", "B"}}, …]}. Throws
/// InputError as `load_json` and `read_pair` do, with the file and the case before it,
/// and if there is no case, or two have the same id.
std::vector<PairCase> read_pair_file(const std::filesystem::path& file);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
