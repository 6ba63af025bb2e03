/// @file
/// What the scenes of chapter 6 share, and each of them.
#pragma once

#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/mass_properties.hpp"
#include "common/physics/world.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

Scene impact_scene();
Scene two_blocks_scene();
Scene bounce_scene();
Scene cradle_scene();
Scene billiards_scene();
Scene elastic_gas_scene();
Scene ramp_scene();
Scene slide_to_roll_scene();
Scene rod_scene();
Scene rocking_block_scene();
Scene stack_scene();
Scene pyramid_scene();
Scene pile_scene();
Scene mass_ratio_scene();
Scene thin_wall_scene();

/// Every solver, as a scene offers it.
std::vector<Method> all_choices();

/// A scene's own parameters, then those of every world: gravity, the solvers' settings
/// and how far the scene stands from the origin. `gravity` [m/s²] is the default.
std::vector<Parameter> with_settings(std::vector<Parameter> own, double gravity = 9.81);

/// A world without bodies, as those parameters and the method say.
World world_of(const Setup& setup);

// Bodies, at rest and upright. Masses in kg, lengths in m.
RigidBody box_body(double mass, const glm::dvec3& size, const glm::dvec3& position);
RigidBody ball_body(double mass, double radius, const glm::dvec3& position);

// Shapes with a surface. The floor is all below y = 0.
Collider box_collider(const glm::dvec3& size, double friction, double restitution);
Collider ball_collider(double radius, double friction, double restitution);
Collider floor_collider(double friction, double restitution);

// Of all bodies that move, in double.

/// [J] of motion and, from the origin's height, in the world's gravity.
double kinetic_energy_of(const World& world);
double energy_of(const World& world);

/// [kg m/s]
glm::dvec3 momentum_of(const World& world);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
