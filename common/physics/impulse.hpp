/// @file
/// What an impulse at a contact does to two bodies, and which impulse an impact is.
/// Source: chapter 6; thesis, Formulas 5 and 6, Listings 5 and 6; W. J. Stronge, Impact
/// Mechanics, 2000.
#pragma once

#include <span>
#include <string_view>

#include "common/physics/rigid_body.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Where two bodies touch, and how their surfaces take it.
struct Impact {
  Vec3 point;         ///< [m] world
  Vec3 normal;        ///< unit, from A to B
  Real restitution;   ///< 0 to 1
  Real friction = 0;  ///< dynamic and static
};

/// (6.1) Velocity [m/s] of B's matter at a point [m] of the world, less that of A's.
Vec3 relative_velocity(const RigidBody& a, const RigidBody& b, const Vec3& point);

/// (6.2) The matrix K [1/kg] of a point: K J is the change of the relative velocity
/// there from an impulse J [N s] on B and -J on A.
Mat3 velocity_per_impulse(const RigidBody& a, const RigidBody& b, const Vec3& point);

/// (6.2) The effective mass [kg] of two bodies at a point along a unit vector: Listing
/// 5. Infinite between bodies that nothing moves.
Real effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point,
                    const Vec3& along);

/// (6.3), (6.4) Formula 6: the impulse [N s] along the normal that turns the closing
/// speed into a parting speed, `restitution` times as large. 0 if they part already.
Real normal_impulse(const RigidBody& a, const RigidBody& b, const Impact& impact);

/// (6.5) The friction impulse that Coulomb's law leaves of a wanted one: within a
/// circle of the radius friction times the normal impulse.
Vec3 in_cone(const Vec3& wanted, Real friction, Real normal_impulse);

/// (6.7) A right-handed basis whose first column is the normal.
Mat3 contact_basis(const Vec3& normal);

/// (6.6) The same within a square along the basis' other two columns, as many engines
/// do it for speed: on its diagonal friction is sqrt 2 too strong.
Vec3 in_pyramid(const Vec3& wanted, Real friction, Real normal_impulse,
                const Mat3& basis);

/// (6.8) Changes the velocities of both: `impulse` [N s] on B, its opposite on A.
/// Listing 6.
void apply_impulse(RigidBody& a, RigidBody& b, const Vec3& point, const Vec3& impulse);

/// A law of impact: the impulse [N s] on B. Zero for bodies that part.
struct ImpactLaw {
  std::string_view name, summary;
  Vec3 (*impulse)(const RigidBody& a, const RigidBody& b, const Impact& impact);
};

/// frictionless: Newton's restitution alone. sequential_friction: that, then friction
/// against the slip that it leaves, once, as game engines sweep over a contact.
/// coupled_friction: Newton's restitution and Coulomb's law of the final slip, both at
/// once; where friction holds it can gain energy. poisson: (6.15) impulses of
/// compression and of restitution, the latter as large as restitution times the former;
/// never gains energy.
std::span<const ImpactLaw> impact_laws();

/// Null if there is none of that name.
const ImpactLaw* find_impact_law(std::string_view name);

}  // namespace timestep::inline TIMESTEP_PRECISION
