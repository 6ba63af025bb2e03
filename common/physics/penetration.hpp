/// @file
/// Bodies that overlap because time comes in steps, and five ways out. Source: chapter
/// 5; thesis, section 2.3, Formula 4, and section 4.3.2; I. Millington, Game Physics
/// Engine Development, 2007, chapter 14; J. Baumgarte, Stabilization of constraints and
/// integrals of motion in dynamical systems, 1972; E. Catto, Iterative dynamics with
/// temporal coherence, GDC 2005.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "common/physics/contact.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// When to stop, and how much to take out.
struct PenetrationSettings {
  int iterations = 20;        ///< over all contacts; of worst_first, contacts resolved
  Real epsilon = Real(1e-4);  ///< [m] worst_first leaves penetrations below this
  Real slop = Real(5e-4);     ///< [m] all others leave this much of each
  Real beta = Real(0.2);      ///< the share that they take out of what is beyond it:
                              ///< velocities in a step, positions in an iteration
};

/// A contact in the frames of its bodies: where its point is on the surface of either
/// [m].
struct ContactAnchors {
  Vec3 on_a, on_b;
};
ContactAnchors anchors_of(const PointContact& contact, const RigidBody& a,
                          const RigidBody& b);

/// (5.1) How deep a contact is [m] where its bodies are now: along the normal, from the
/// one anchor to the other.
Real depth_now(const PointContact& contact, const ContactAnchors& anchors,
               const RigidBody& a, const RigidBody& b);

/// (5.3) How fast [m/s] a body's point at `arm` [m] from its centre of mass moves along
/// a unit normal after 1 N s along it: the inverse mass, and the share of the turn
/// [1/kg].
Real inverse_effective_mass(const RigidBody& body, const Vec3& arm, const Vec3& normal);

/// (5.3) Moves and turns a body as an impulse [kg m] at `arm` [m] from its centre of
/// mass does, in a second.
void push(RigidBody& body, const Vec3& arm, const Vec3& impulse);

/// Room for what the ways out keep while they iterate.
struct PenetrationRoom {
  std::vector<ContactAnchors> anchors;
  std::vector<RigidBody> pseudo;  ///< bodies with the velocities that only push
  std::vector<Real> impulses;     ///< [N s] along the normals
  long long solved = 0;           ///< how often some depth was taken out of a contact
};

/// A way out. It moves the bodies, or gives them velocities that do in a step of dt
/// [s], and leaves in each contact the depth that is left.
using PenetrationStep = void (*)(std::span<RigidBody> bodies,
                                 std::span<PointContact> contacts,
                                 const PenetrationSettings& settings, Real dt,
                                 PenetrationRoom& room);

/// (5.2) Formula 4: apart along the normal, each body by its share of the inverse mass.
/// Nothing turns.
void linear_projection(std::span<RigidBody> bodies, std::span<PointContact> contacts,
                       const PenetrationSettings& settings, Real dt,
                       PenetrationRoom& room);

/// (5.3) The deepest contact first, out as a whole: by motion and turn, each with its
/// share of the inverse effective mass. Until the deepest is below epsilon.
void worst_first_projection(std::span<RigidBody> bodies,
                            std::span<PointContact> contacts,
                            const PenetrationSettings& settings, Real dt,
                            PenetrationRoom& room);

/// (5.4) Impulses that make each contact part at beta (depth - slop) / dt: a velocity
/// that the bodies keep.
void baumgarte(std::span<RigidBody> bodies, std::span<PointContact> contacts,
               const PenetrationSettings& settings, Real dt, PenetrationRoom& room);

/// (5.5) The same with velocities beside the bodies' own, that are forgotten after the
/// step.
void split_impulse(std::span<RigidBody> bodies, std::span<PointContact> contacts,
                   const PenetrationSettings& settings, Real dt, PenetrationRoom& room);

/// (5.6) Non-linear Gauss-Seidel: contact by contact a share of the depth that there is
/// now, after all that moved before.
void ngs(std::span<RigidBody> bodies, std::span<PointContact> contacts,
         const PenetrationSettings& settings, Real dt, PenetrationRoom& room);

/// A way out by its name.
struct PenetrationMethod {
  std::string_view name, summary;
  PenetrationStep step;
};

/// linear_projection, worst_first, baumgarte, split_impulse, ngs.
std::span<const PenetrationMethod> penetration_methods();

/// Null if there is none of that name.
const PenetrationMethod* find_penetration_method(std::string_view name);

}  // namespace timestep::inline TIMESTEP_PRECISION
