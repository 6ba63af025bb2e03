/// @file
/// Bodies that overlap, and a step that lets them out: without friction, without
/// bounces. Chapter 6 has a world in its place.
#pragma once

#include <string>
#include <vector>

#include "common/physics/penetration.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {

struct Overlap {
  std::vector<RigidBody> bodies;
  std::vector<Collider> colliders;
  std::vector<PointContact> contacts;  ///< of the last step, with the depths left
  PenetrationSettings settings;        ///< iterations are sweeps, of worst_first too
  Real gravity = 0;                    ///< [m/s²] downwards
  ContactSearch search;
  PenetrationRoom room;
};

/// Adds a body with one collider.
void add(Overlap& overlap, const RigidBody& body, const Shape& shape);

/// Adds what does not move: all points with dot(normal, point) <= offset [m].
void add_plane(Overlap& overlap, const Vec3& normal, Real offset);

/// A step of dt [s]: fall, find the contacts, stop what approaches, take penetration
/// out, move. Returns how many contacts the way out has worked on.
long long step(Overlap& overlap, PenetrationStep way_out, Real dt);

/// The deepest penetration [m] where the bodies are; 0 if nothing overlaps.
Real deepest(const Overlap& overlap);

/// Kinetic energy and potential energy over y = 0 [J].
double total_energy(const Overlap& overlap);

/// Both bodies of a contact by half of its depth, whatever their masses: what Formula 4
/// is there to avoid. Static bodies stay.
void equal_shares(std::span<RigidBody> bodies, std::span<PointContact> contacts,
                  const PenetrationSettings& settings, Real dt, PenetrationRoom& room);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
