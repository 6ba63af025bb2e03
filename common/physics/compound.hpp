/// @file
/// Compound shapes: bodies of several convex parts, as a concave one is decomposed.
/// Source: chapter 4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/physics/decomposition.hpp"
#include "common/physics/manifold.hpp"
#include "common/physics/pair_query.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

struct CompoundPart {
  Shape shape;
  Pose pose{};  ///< body from part
};

/// One part or more, to outlive the query. A single shape is a compound of one part.
using Compound = std::span<const CompoundPart>;

/// The parts of a decomposition, which must outlive them where it is.
std::vector<CompoundPart> compound_parts(const Decomposition& decomposition);

/// The smallest box along the world's axes, up to a few roundings.
Bounds bounds(Compound compound, const Pose& pose);

/// [m³] The sum over the parts: what two of them share counts twice.
Real volume(Compound compound);

/// What two parts, by their numbers, have to do with each other.
struct PartSeparation {
  Separation separation;
  std::uint32_t part_a = 0, part_b = 0;
};

/// (4.30) The least signed distance of a part of A and a part of B. Of compounds that
/// are apart it is their distance. Of those that overlap it is the depth of the deepest
/// pair: to move along its normal frees that pair, but perhaps not the others.
/// `iterations` counts the support points for all pairs; `no_answer` without any parts.
PartSeparation separation(Compound a, const Pose& pose_a, Compound b,
                          const Pose& pose_b);

/// Where two parts touch.
struct PartContact {
  PartSeparation parts;
  Manifold manifold;
};

/// The manifolds of all pairs of parts that are no further apart than `margin` [m, not
/// negative], in the order of the parts. Returns how many there are; what there is no
/// room for is left out.
std::size_t contact_manifolds(Compound a, const Pose& pose_a, Compound b,
                              const Pose& pose_b, Real margin,
                              std::span<PartContact> contacts);

}  // namespace timestep::inline TIMESTEP_PRECISION
