/// @file
/// Exercise 5.2, core: Up, or level?
#pragma once

#include "common/physics/rigid_body.hpp"

namespace timestep {

/// (5.3) How fast [m/s] a point of the body moves along the unit `normal` after an
/// impulse of 1 N s along it, which acts at that point: `arm` [m] from the centre of
/// mass. World frame; [1/kg].
Real inverse_mass_at(const RigidBody& body, const Vec3& arm, const Vec3& normal);

/// What a push does: it moves the centre of mass [m] and turns the body [rad].
struct Motion {
  Vec3 moved, turned;
};

/// (5.3) Of the push along the unit `normal`, at `arm` [m] from the centre of mass,
/// that takes that point `length` [m] along it.
Motion push_by(const RigidBody& body, const Vec3& arm, const Vec3& normal, Real length);

}  // namespace timestep
