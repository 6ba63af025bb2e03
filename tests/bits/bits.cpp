// Prints the bits that the physics ends with, so that builds can be compared: every
// method under every force, the systems, contacts, worlds, and the exact motions.
// Compiled once for each precision.
#include <array>
#include <cstdio>
#include <cstring>
#include <span>
#include <vector>

#include "common/physics/distance_constraint.hpp"
#include "common/physics/dormand_prince.hpp"
#include "common/physics/epa.hpp"
#include "common/physics/euler.hpp"
#include "common/physics/exact_orbit.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "common/physics/forces.hpp"
#include "common/physics/manifold.hpp"
#include "common/physics/mesh_mass.hpp"
#include "common/physics/rigid_body.hpp"
#include "common/physics/rotations.hpp"
#include "common/physics/rounding.hpp"
#include "common/physics/sat.hpp"
#include "common/physics/schemes.hpp"
#include "common/physics/stability.hpp"
#include "common/physics/systems.hpp"
#include "tests/shape_pairs.hpp"
#include "tests/world_scenes.hpp"

using namespace timestep;

namespace {

template <class Number>
void print(const char* what, Number value) {
  unsigned char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  std::printf("%s ", what);
  for (const unsigned char byte : bytes) std::printf("%02x", unsigned{byte});
  std::printf("\n");
}

// A cloud of particles on springs, in gravity and both kinds of drag.
constexpr std::size_t k_size = 64;

State cloud_start(std::size_t n) {
  State cloud = particles(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto s = Real(i) / Real(n);
    put(cloud.x, i, {s, 2 - s, s * s});
    put(cloud.v, i, {1 - s, s / 3, Real(0.1) * s});
  }
  return cloud;
}

void cloud_forces(std::span<const Real> x, std::span<const Real> v, Real t,
                  std::span<Real> a) {
  for (std::size_t i = 0; i < x.size() / 3; ++i) {
    const Real m = 1 + Real(i) / 7;
    const Vec3 force =
        weight(m, {0, Real(-9.81), 0}) + spring(m * 30, at(x, i), {t / 10, 0, 0})
        + linear_drag(Real(0.3), at(v, i)) + quadratic_drag(Real(0.02), at(v, i));
    put(a, i, newton(force, 1 / m));
  }
}

void print_state(const char* what, const State& state) {
  for (const Real x : state.x) print(what, x);
  for (const Real v : state.v) print(what, v);
}

// 1,000 steps of a method of chapter 1, with the thesis's damping
void print_cloud(const NamedIntegrator& method) {
  State cloud = cloud_start(k_size);
  for (int i = 0; i < 1000; ++i) {
    method.step(cloud, cloud_forces, Real(i) / 60, Real(1) / 60);
    for (Real& v : cloud.v) v *= damping_factor(Real(0.9), Real(1) / 60);
  }
  print_state(method.name.data(), cloud);
}

// 200 steps of a scheme; implicit ones solve for all particles at once, so there are
// few
void print_cloud(const Scheme& scheme) {
  const State start = cloud_start(scheme.evaluations == 0 ? 2 : k_size);
  Integration cloud = begin(scheme, cloud_forces, start, Real(1) / 60);
  for (int i = 0; i < 200; ++i) advance(cloud);
  print_state(scheme.name.data(), read(cloud));
  print(scheme.name.data(), spectral_radius(step_matrix(scheme, Real(0.7))));
  print(scheme.name.data(), stability_limit(scheme));
}

// What chapter 2 simulates beside clouds
void print_systems() {
  const DoublePendulum two{1, Real(0.5), Real(1.2), Real(0.7), Real(9.81)};
  State swing{.x = {2, 1}, .v = {0, 0}, .a = {0, 0}};
  const Acceleration swinging = [&](auto x, auto v, Real, auto a) {
    double_pendulum(two, x, v, a);
  };
  dormand_prince(swing, swinging, 0, 2, {Real(1e-5), Real(1e-5)});
  print_state("double pendulum", swing);
  print("energy", energy(two, swing.x, swing.v));

  State orbit = particles(1);
  put(orbit.x, 0, {Real(0.5), 0, 0});
  put(orbit.v, 0, {0, Real(1.7), 0});
  const Acceleration gravity = [](auto x, auto, Real, auto a) {
    put(a, 0, gravity_towards_origin(1, at(x, 0)));
  };
  Integration round = begin(*find_scheme("rk4"), gravity, orbit, Real(0.02));
  for (int i = 0; i < 500; ++i) advance(round);
  print_state("orbit", round.state);

  State rope = cloud_start(8);
  std::vector<DistanceConstraint> links;
  for (std::size_t i = 0; i + 1 < 8; ++i) links.push_back({i, i + 1, Real(0.3)});
  const std::vector<Real> inverse_mass{0, 1, 1, Real(0.5), 1, 2, 1, 3};
  satisfy(links, inverse_mass, 20, rope.x);
  print_state("rope", rope);
}

// A twisted prism's mass properties and principal axes
void print_mass() {
  std::vector<Vec3> vertices;
  for (int i = 0; i < 6; ++i) {
    const Real x = i % 3, y = Real(i) / 7, z = i < 3 ? 0 : 3;
    vertices.emplace_back(x + Real(0.1) * z, x * x / 3 - y, z + x * y);
  }
  const std::vector<Triangle> triangles{{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                                        {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  const MassProperties body = mesh_mass(Real(2.7), vertices, triangles);
  const auto [moments, A] = principal_axes(body.inertia);
  print("mass", body.mass);
  for (int i = 0; i < 3; ++i) {
    print("centre", body.centre_of_mass[i]);
    print("moment", moments[i]);
    for (int j = 0; j < 3; ++j) print("tensor", body.inertia[i][j] + A[i][j]);
  }
}

// 500 steps of a brick on a spring at one of its corners
void print_brick(const RotationMethod& method) {
  RigidBody brick{.velocity = {1, 0, Real(0.5)},
                  .angular_velocity = {Real(0.4), 1, Real(0.8)},
                  .inverse_mass = 1,
                  .inverse_inertia = {1, Real(0.5), Real(0.4)}};
  for (int i = 0; i < 500; ++i) {
    const Vec3 corner = world_point(brick, {1, Real(0.5), Real(0.3)});
    add_force_at_point(brick, spring(Real(0.2), corner, {0, 2, 0}), corner);
    integrate(brick, method.step, Real(1) / 60);
  }
  const Rotation r = rotation_of(brick);
  print(method.name.data(), r.q.w + r.q.x + r.q.y + r.q.z);
  for (int i = 0; i < 3; ++i) print(method.name.data(), brick.position[i] + r.omega[i]);
}

Real sum(const Vec3& v) {
  return v.x + v.y + v.z;
}

// Three hundred pairs of shapes, then of hulls with their faces
void print_contacts() {
  Random random(4);
  std::array<std::vector<Vec3>, 2> points;
  for (int i = 0; i < 300; ++i) {
    const Shape a = random_shape(random, i % k_shape_kinds, 1, points[0]);
    const Shape b = random_shape(random, i % 5, 1, points[1]);
    const Pose pose_a{random.in_cube(), random.turn()};
    const Pose pose_b{random.in_cube(), random.turn()};
    const Separation s = separation(convex(a), pose_a, convex(b), pose_b);
    print("separation", s.distance + sum(s.normal) + sum(s.on_a) + sum(s.on_b));
  }
  for (int i = 0; i < 100; ++i) {
    const ConvexHull a = random_hull(random, 20), b = box_hull(random.sizes(0.1, 1));
    const Pose pose_a{random.in_cube(), random.turn()};
    const Pose pose_b{random.in_cube(), random.turn()};
    const Separation s = sat(a, pose_a, b, pose_b).separation;
    print("sat", s.distance + sum(s.normal) + a.volume);
    const Manifold manifold = contact_manifold(a, pose_a, b, pose_b, s);
    for (const ContactPoint& c :
         std::span(manifold.points).first(std::size_t(manifold.count)))
      print("contact", sum(c.position));
  }
}

// A pile after a second, by each solver; rolling friction and bounces are in it
void print_worlds() {
  for (const Solver& solver : solvers()) {
    World world = pile_of(solver.name == "lcp" ? 3 : 12);
    world.solver = &solver;
    for (Collider& collider : world.colliders) {
      collider.restitution = Real(0.25) * Real(collider.id % 3);
      collider.rolling_friction = Real(0.01) * Real(collider.id % 2);
    }
    run(world, 60);
    for (const RigidBody& body : world.bodies) {
      print(solver.name.data(), sum(body.position));
      print(solver.name.data(), body.orientation.w + sum(body.angular_velocity));
    }
  }
}

}  // namespace

int main() {
  for (const NamedIntegrator& method : euler_methods()) print_cloud(method);
  for (const Scheme& scheme : schemes()) print_cloud(scheme);
  for (const Scheme& scheme : drag_schemes()) print_cloud(scheme);
  print_systems();
  print_mass();
  for (const RotationMethod& method : rotation_methods()) print_brick(method);
  print_contacts();
  print_worlds();
  print("clock", accumulated_time(Real(1) / 60, 100'000));
  for (int i = 0; i < 50; ++i) {
    const double t = 0.1 * i;
    const auto m =
        exact::quadratic_drag({{0, 1, 0}, {20, 25, -5}}, {0, -9.81, 0}, 0.05, t);
    const auto l = exact::linear_drag({{0, 1, 0}, {20, 25, -5}}, {0, -9.81, 0}, 0.3, t);
    print("quadratic", m.x.x + m.x.y + m.v.x + m.v.y);
    print("linear", l.x.x + l.x.y + l.v.x + l.v.y);
    print("oscillator", exact::oscillator({1, 2}, 3, 0.1 * i, t).x);
    print("orbit", exact::orbit(1, 1, 0.7, t).x.x);
    print("pendulum", exact::pendulum({1, 0.1 * i}, 2, t).x);
  }
  return 0;
}
