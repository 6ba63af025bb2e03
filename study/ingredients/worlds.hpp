/// @file
/// Worlds that are measured. Source: chapter 7.
#pragma once

#include <functional>

#include "common/physics/world.hpp"
#include "study/ingredients/comparison.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {

inline constexpr double k_dt = 1.0 / 60;
inline constexpr double k_gravity = 9.81;  ///< [m/s²]

/// A world of level ground, body 0, with such a surface.
World ground(const Collider& surface);

/// A body of so many kg; `surface` says all but its shape. Returns its index.
std::size_t add_ball(World& world, double mass, double radius, const glm::dvec3& place,
                     Collider surface);
std::size_t add_box(World& world, double mass, const glm::dvec3& size,
                    const glm::dvec3& place, Collider surface);

using WorldStep = std::function<void(World& world)>;

/// Of a world after a time [s].
using ErrorOf = std::function<double(const World& world, double time)>;

/// A copy of a world under way, by `step` unless another step is given.
study::Motion moving(const World& world, const ErrorOf& error);
study::Motion moving(const World& world, const ErrorOf& error, const WorldStep& step);

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
