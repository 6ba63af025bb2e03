/// @file
/// The pairs of chapter 4's truth cases: as shapes of either precision, and what double
/// says of an answer whatever the precision it comes from.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "tests/truth/kind.hpp"

namespace timestep::truth {

inline constexpr std::array<std::string_view, 9> k_pair_kinds{
    "convex_pair",     "shape_pair",           "geom_sphere_sphere",
    "geom_sphere_box", "geom_capsule_capsule", "geom_capsule_box",
    "geom_plane",      "geom_sphere_cylinder", "geom_cylinder_box"};

/// How far apart the shapes are along a direction, of any length [m]: no more than
/// their signed distance, and just that along a normal that is right.
double gap_along(const std::string& kind, const Json& inputs,
                 const glm::dvec3& direction);

/// A witness point of each shape [m].
struct Witnesses {
  glm::dvec3 on_a, on_b;
};

/// How wrong witness points are by themselves [m], whatever others there are that serve
/// as well: how far from their shapes, from the planes across the normal that their
/// shapes touch, or from `distance` along the normal from each other.
double witness_error(const std::string& kind, const Json& inputs,
                     const glm::dvec3& normal, double distance,
                     const Witnesses& witnesses);

/// How far a point of either shape may move, together, when the numbers of the inputs
/// are rounded to a unit round-off u [m].
double displacement(const std::string& kind, const Json& inputs, double u);

}  // namespace timestep::truth
