/// @file
/// Exercise 3.2, core: A hammer from its parts
#pragma once

#include "common/physics/real.hpp"

namespace timestep {

/// How the mass of a body is spread about axes along x, y and z: the diagonal of its
/// inertia tensor (3.7). A hole is a body of negative mass and negative moments.
struct Spread {
  Real mass;     ///< [kg]
  Vec3 centre;   ///< of mass [m]
  Vec3 moments;  ///< about the axes through the centre of mass [kg m²]
};

/// (3.9) The moments [kg m²] about the axes through a point [m].
Vec3 moments_about(const Spread& body, const Vec3& point);

/// Two bodies as one.
Spread joined(const Spread& a, const Spread& b);

/// A thin rod along z, from 0 to `length` [m], with a box of head_size [m] whose centre
/// is at the rod's upper end. Masses in kg. The handle's hole in the head is left out.
Spread hammer(Real handle_mass, Real length, Real head_mass, const Vec3& head_size);

}  // namespace timestep
