/// @file
/// A world of rigid bodies that fall, collide and come to rest. Source: chapter 6;
/// thesis, section 4.3.2, Listing 9.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/physics/sleeping.hpp"
#include "common/physics/solvers.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

/// Thrown for what a world cannot take. `what()` says in a short phrase what is wrong.
struct WorldError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A body of a world, as long as it is there. Places of removed bodies are used again,
/// in another generation.
struct BodyHandle {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;  ///< 0: none
};

/// Bodies, how they move, and what a step leaves for the next one. Metres, kilograms,
/// seconds, world frame.
struct World {
  // What there is. A removed body's place stays, as a static body without colliders.
  std::vector<RigidBody> bodies;           ///< may be changed between two steps
  std::vector<std::uint32_t> generations;  ///< of the bodies
  std::vector<bool> is_there;              ///< false: the place is free
  std::vector<Collider> colliders;         ///< in the order in which they were added
  std::uint32_t next_collider = 0;         ///< the id of the next one

  // How it moves
  SolverSettings settings;          ///< gravity, steps within a step, sweeps
  PenetrationSettings penetration;  ///< for solvers that need a way out
  const Solver* solver = find_solver("substeps");
  const PenetrationMethod* out_of_penetration = find_penetration_method("ngs");
  const ImpactLaw* impact_law = find_impact_law("coupled_friction");  ///< worst_first's
  Real margin = Real(0.01);  ///< [m] contacts are looked for up to this distance
  SleepSettings sleep;       ///< off by default

  // The last step's contacts, those of the step before, and room to work
  std::vector<PointContact> contacts, contacts_before;
  ContactSearch search;
  Sleepers sleepers;
  SolverRoom room;
  PenetrationRoom penetration_room;
};

/// What is wrong with a body, or with a collider, in a short phrase; empty if nothing
/// is. Numbers must be finite, the orientation of length one, inverse masses and
/// inertias not negative; sizes positive, frictions not negative, restitution 0 to 1.
std::string body_fault(const RigidBody& body);
std::string collider_fault(const Collider& collider);

/// Adds a body with its shapes, all checked. A collider's `body` and `id` are set here.
BodyHandle add_body(World& world, const RigidBody& body,
                    std::span<const Collider> colliders);
BodyHandle add_body(World& world, const RigidBody& body, const Collider& collider);

/// Throws WorldError, as all below, for a body that is not there any more. All that
/// sleep wake.
void remove_body(World& world, BodyHandle handle);

RigidBody& body_of(World& world, BodyHandle handle);
const RigidBody& body_of(const World& world, BodyHandle handle);

/// (6.16) Everything moves on by dt [s], under gravity and the forces that were added
/// since the last step. Throws WorldError if dt, a setting or a body is not as it must
/// be, with nothing changed.
void step(World& world, Real dt);

/// The mass properties of a box, a ball, … as a body's. Its frame must be the principal
/// one, as that of all shapes about their centre of mass is.
RigidBody body_with_mass(Real mass, const Mat3& inertia);

}  // namespace timestep::inline TIMESTEP_PRECISION
