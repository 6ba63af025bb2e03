/// @file
/// Impacts of two bodies, in double: what an engine's impulses are measured against.
/// All vectors in the world frame; the normal is a unit vector from A to B; impulses [N
/// s] act on B, and their opposites on A. With the 3x3 matrix K = sum(1/m) 1 - sum [r]
/// I^-1 [r], an impulse j changes the velocity of B relative to A at the point by K j.
/// Source: chapter 6; Kane and Levinson, Dynamics (1985);
/// Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts (1996).
#pragma once

#include <optional>

#include "common/physics/exact_cue_ball.hpp"

namespace timestep::exact {

/// A body in an impact. Both inverses 0: it is static. The other one then has an
/// inverse mass above 0.
struct Body {
  double inverse_mass;          ///< [1/kg]
  glm::dmat3 inverse_inertia;   ///< [1/(kg m²)], world frame
  glm::dvec3 position;          ///< of the centre of mass [m]
  glm::dvec3 velocity;          ///< [m/s]
  glm::dvec3 angular_velocity;  ///< [rad/s]
};

/// Where two bodies touch and how.
struct Touch {
  glm::dvec3 point;   ///< [m]
  glm::dvec3 normal;  ///< unit, from A to B
  double restitution, mu;
};

enum class Slip { frictionless, sticks, slides, parts };  ///< parts: no impulse

struct Impulse {
  glm::dvec3 j;  ///< on B [N s]
  Slip slip;     ///< how friction took part
};

/// Velocity of B relative to A at the point [m/s].
glm::dvec3 relative_velocity(const Body& a, const Body& b, const Touch& touch);

/// The impulse along the normal that leaves the speed -e v_n. Its loss of energy is
/// (1 - e²) v_n² / (2 n·K n).
Impulse frictionless(const Body& a, const Body& b, const Touch& touch);

/// One pass of a game's solver: that impulse, then friction against the slip that it
/// leaves, of what would stop the slip or mu times that. Where K couples the two, the
/// second undoes part of the first: bodies may be left closing.
Impulse sequential_friction(const Body& a, const Body& b, const Touch& touch);

/// Newton's restitution and Coulomb's friction at once: the normal speed after is -e
/// v_n, and friction either stops the slip or is mu j_n against the slip after. There
/// is always such an impulse; of several it is one that sticks, if there is one. May
/// gain energy: e compares speeds, whatever friction did to them.
Impulse coupled_friction(const Body& a, const Body& b, const Touch& touch);

/// Poisson's restitution, in two phases. Compression: coupled_friction with e = 0 to
/// the impulse c. Expansion: a normal impulse of e c_n, or more if that left the bodies
/// closing, with friction that is at most mu times it and leaves the least energy.
/// Never gains energy for e <= 1: e c would be allowed, and takes the energy from what
/// it is at c to no more than it was.
Impulse poisson(const Body& a, const Body& b, const Touch& touch);

/// The bodies after it.
Body pushed(Body body, const glm::dvec3& j, const glm::dvec3& point);

/// A ball that falls on its table and bounces off it. Here all laws with friction
/// agree: an impulse along the normal does not change the slip.
struct BallBounce {
  Impulse impulse;
  BallMotion after;
};
BallBounce bounced(const Ball& ball, double restitution, const BallMotion& before);

/// Discs without friction in a plane.
struct Disc {
  double mass;    ///< [kg], above 0
  double radius;  ///< [m], not below 0
  glm::dvec2 x, v;
};

struct DiscImpact {
  double time;         ///< [s], not below 0
  glm::dvec2 normal;   ///< from the first to the second
  double impulse;      ///< [N s]
  Disc first, second;  ///< right after, where they are then
};

/// The impact of two discs in straight flight, unless they miss. Discs that overlap and
/// close meet at once.
std::optional<DiscImpact> disc_impact(const Disc& first, const Disc& second, double e);

/// A rectangle that falls on a corner without spin, its base turned by `tilt`
/// counter-clockwise from the floor.
struct FallingBox {
  double mass;           ///< [kg], above 0
  double width, height;  ///< [m], above 0
  double tilt;           ///< [rad]
  double speed;          ///< downwards [m/s], not below 0
};

/// From its centre to the lowest corner [m]; the left one of two.
glm::dvec2 lowest_corner(const FallingBox& box);

/// Motion after and the impulse [N s] on it.
struct BoxImpact {
  double omega;  ///< [rad/s], counter-clockwise
  glm::dvec2 v, impulse;
};

/// The corner bounces off smooth ground, or stays where it is.
BoxImpact corner_bounces(const FallingBox& box, double e);
BoxImpact corner_catches(const FallingBox& box);

}  // namespace timestep::exact
