/// @file
/// Worlds that the tests of chapter 6 share.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "common/physics/mass_properties.hpp"
#include "common/physics/world.hpp"

namespace timestep::inline TIMESTEP_PRECISION {

inline constexpr Real k_60_hz = Real(1) / 60;
inline constexpr Real k_g = Real(9.81);
inline const Vec3 k_half(Real(0.5));  ///< half the sides [m] of most boxes

inline RigidBody box(Real mass, const Vec3& half, const Vec3& position) {
  RigidBody body = body_with_mass(mass, solid_box(mass, Real(2) * half).inertia);
  body.position = position;
  return body;
}

inline RigidBody ball(Real mass, Real radius, const Vec3& position) {
  RigidBody body = body_with_mass(mass, solid_sphere(mass, radius).inertia);
  body.position = position;
  return body;
}

inline Collider surface(const Shape& shape, Real friction, Real restitution) {
  Collider collider;
  collider.shape = shape;
  collider.friction = friction;
  collider.restitution = restitution;
  return collider;
}

inline World with_floor(Real friction = Real(0.5), Real restitution = 0) {
  World world;
  add_body(world, {}, surface(HalfSpace{{0, 1, 0}, 0}, friction, restitution));
  return world;
}

inline void run(World& world, int steps, Real dt = k_60_hz) {
  for (int i = 0; i < steps; ++i) step(world, dt);
}

/// Kinetic and of height [J].
inline double energy(const World& world) {
  double sum = 0;
  const glm::dvec3 g(world.settings.gravity);
  for (const RigidBody& body : world.bodies)
    sum +=
        kinetic_energy(body) - mass_of(body) * glm::dot(g, glm::dvec3(body.position));
  return sum;
}

/// Of all contacts of the last step [m].
inline Real deepest(const World& world) {
  Real most = 0;
  for (const PointContact& c : world.contacts) most = std::max(most, c.depth);
  return most;
}

/// Of all bodies: of their centres, and of points half a metre away [m/s].
inline Real fastest(const World& world) {
  Real most = 0;
  for (const RigidBody& body : world.bodies)
    most = std::max(
        {most, glm::length(body.velocity), glm::length(body.angular_velocity) / 2});
  return most;
}

inline World column_of(int n) {
  World world = with_floor();
  for (int i = 0; i < n; ++i)
    add_body(world, box(1, k_half, {0, Real(0.5) + Real(i), 0}),
             {.shape = Box{k_half}});
  return world;
}

inline World pyramid_of(int base) {
  World world = with_floor();
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const Real x = Real(1.1) * (Real(i) - Real(base - 1 - row) / 2);
      add_body(world, box(1, k_half, {x, Real(0.5) + Real(row), 0}),
               {.shape = Box{k_half}});
    }
  }
  return world;
}

/// Boxes that fall on each other askew.
inline World pile_of(int n) {
  World world = with_floor();
  std::uint32_t state = 1;
  const auto random = [&] {
    state = state * 1664525U + 1013904223U;
    return Real(state >> 8) * Real(0x1p-24) - Real(0.5);
  };
  for (int i = 0; i < n; ++i) {
    const int row = i / 5 % 5, layer = i / 25;
    const Vec3 place(Real(i % 5), Real(1 + layer), Real(row));
    RigidBody body = box(1, k_half, Real(1.5) * place);
    const Real along_x = random(), along_z = random();
    body.position += Vec3{along_x, 0, along_z};
    const Real x = random(), y = random(), z = random();
    body.orientation = glm::normalize(Quat{1, x, y, z});
    add_body(world, body, {.shape = Box{k_half}});
  }
  return world;
}

/// FNV-1a of all positions and orientations, bit by bit.
inline std::uint64_t hash_of(const World& world) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  std::uint64_t hash = 14695981039346656037U;
  for (const RigidBody& body : world.bodies) {
    const Vec3& x = body.position;
    const Quat& q = body.orientation;
    for (const Real number : {x.x, x.y, x.z, q.w, q.x, q.y, q.z})
      hash = (hash ^ std::bit_cast<Bits>(number)) * 1099511628211U;
  }
  return hash;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
