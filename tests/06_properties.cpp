// What holds in every world by every solver: momentum, Coulomb's bound, numbers that
// are finite, and two bodies being alike.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/catch.hpp"
#include "tests/world_scenes.hpp"

using namespace timestep;

namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

// Random numbers whose sequence the standard fixes
struct Random {
  std::mt19937 bits;
  explicit Random(unsigned seed) : bits(seed) {}
  Real operator()(Real low, Real high) {
    return low + (high - low) * Real(bits()) / Real(std::mt19937::max());
  }
  Real decades(Real low, Real high) { return std::pow(Real(10), (*this)(low, high)); }
  Vec3 vector(Real size) {
    const Real x = (*this)(-size, size), y = (*this)(-size, size);
    return {x, y, (*this)(-size, size)};
  }
};

// A few boxes and balls of all sizes, masses, surfaces and speeds, in each other's way
World extreme_world(Random& random) {
  const Real size = random.decades(-3, 3);
  World world = with_floor(random(0, 1) < Real(0.2) ? 100 : random(0, 1), random(0, 1));
  world.settings.gravity *= random.decades(-2, 2);
  world.margin = size / 100;
  for (int i = 0; i < 6; ++i) {
    const Real mass = random.decades(-6, 6), speed = size * random.decades(-2, 3);
    const Vec3 half = size * Vec3(random.decades(-2, 0), random.decades(-1, 0), 1);
    const Vec3 place = 2 * size * Vec3(random(-1, 1), random(0, 2), random(-1, 1));
    const bool is_ball = random(0, 1) < Real(0.3);
    RigidBody body = is_ball ? ball(mass, size, place) : box(mass, half, place);
    body.orientation = rotation_by(random.vector(3));
    body.velocity = random.vector(speed);
    body.angular_velocity = random.vector(speed / size);
    add_body(world, body,
             surface(is_ball ? Shape(Sphere{size}) : Shape(Box{half}),
                     random(0, 1) < Real(0.2) ? 100 : random(0, 1), random(0, 1)));
  }
  return world;
}

glm::dvec3 momentum(const World& world) {
  glm::dvec3 sum(0);
  for (const RigidBody& body : world.bodies)
    sum += mass_of(body) * glm::dvec3(body.velocity);
  return sum;
}

glm::dvec3 angular_momentum(const World& world) {
  glm::dvec3 sum(0);
  for (const RigidBody& body : world.bodies)
    sum += angular_momentum_about(body, glm::dvec3(0));
  return sum;
}

// Two boxes that meet corner to face in the air, in either order
World meeting(const Solver& solver, bool is_swapped, Real restitution) {
  World world;
  world.solver = &solver;
  world.settings.gravity = Vec3(0);
  RigidBody slow = box(3, k_half, {0, 0, 0});
  RigidBody fast = box(1, k_half, {Real(0.2), Real(1.5), Real(0.1)});
  slow.angular_velocity = {Real(0.1), Real(0.3), Real(-0.2)};
  fast.orientation = rotation_by({Real(0.5), Real(0.2), Real(0.4)});
  fast.velocity = {Real(0.5), -2, Real(0.3)};
  fast.angular_velocity = {1, Real(-0.5), 2};
  const Collider collider = surface(Box{k_half}, Real(0.4), restitution);
  add_body(world, is_swapped ? fast : slow, collider);
  add_body(world, is_swapped ? slow : fast, collider);
  return world;
}

}  // namespace

TEST_CASE("two boxes that collide keep their momentum, by every solver") {
  for (const Solver& solver : solvers()) {
    INFO(solver.name);
    World world = meeting(solver, false, Real(0.5));
    const glm::dvec3 p = momentum(world), L = angular_momentum(world);
    run(world, 60);
    CHECK(world.bodies[0].velocity != Vec3(0));  // they met

    // 60 steps of at most 100 roundings each of some 5 kg m/s
    CHECK(glm::length(momentum(world) - p) <= 6000 * 5 * k_u);

    // The impulses that a contact's two ends are given act through one point where its
    // surfaces meet. They are a gap or a penetration apart before that, up to the
    // margin, and orbits are summed in steps: a share of that of 5 kg m/s over 1.5 m
    CHECK(glm::length(angular_momentum(world) - L) <= 0.01 * 5);
  }
}

TEST_CASE("the two bodies of a contact are alike to every solver") {
  for (const Solver& solver : solvers()) {
    INFO(solver.name);
    World one = meeting(solver, false, Real(0.5)),
          other = meeting(solver, true, Real(0.5));
    run(one, 60);
    run(other, 60);
    for (const std::size_t i : {0, 1}) {
      const RigidBody &a = one.bodies[i], &b = other.bodies[1 - i];

      // One impact, of which a rounding of each place turns the normal and moves the
      // arms: some hundred roundings of speeds up to 3, over 60 steps of flight
      CHECK(glm::length(a.position - b.position) <= 1000 * k_u);
      CHECK(glm::length(a.velocity - b.velocity) <= 1000 * k_u);
      CHECK(glm::length(a.angular_velocity - b.angular_velocity) <= 1000 * k_u);
    }
  }
}

TEST_CASE("every contact of every solver obeys Coulomb's bound") {
  for (const Solver& solver : solvers()) {
    INFO(solver.name);
    World world = pile_of(solver.name == "lcp" ? 4 : 30);
    world.solver = &solver;
    int touching = 0;
    for (int i = 0; i < 120; ++i) {
      step(world, k_60_hz);
      for (const PointContact& c : world.contacts) {
        const Real normal = glm::dot(c.impulse, c.normal);
        const Real size = glm::length(c.impulse);
        const Real slip = glm::length(c.impulse - normal * c.normal);
        touching += normal > 0 ? 1 : 0;

        // Sweeps take the slip of 1 kg from velocities of some 5 m/s
        CHECK(normal >= -8 * k_u * (size + 5));
        CHECK(slip <= c.friction * normal + 16 * k_u * (size + 5));
      }
    }
    CHECK(touching > 100);
  }
}

TEST_CASE("a step never makes what is not a number") {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const World start = extreme_world(random);
    const Real dt = random.decades(-5, -1);
    for (const Solver& solver : solvers()) {
      INFO(solver.name << ' ' << i);
      World world = start;
      world.solver = &solver;
      for (int k = 0; k < (solver.name == "lcp" ? 5 : 20); ++k) step(world, dt);
      for (const RigidBody& body : world.bodies) CHECK(body_fault(body).empty());
    }
  }
}

TEST_CASE("a box that bounces without friction and loss keeps its energy") {
  for (const char* solver : {"substeps", "sequential_impulses"}) {
    for (const int hertz : {60, 240, 960}) {
      INFO(solver << ' ' << hertz);
      World world = with_floor(0, 1);
      world.solver = find_solver(solver);
      const Vec3 half(Real(0.5), Real(0.25), Real(0.35));
      RigidBody body = box(1, half, {0, 3, 0});
      body.orientation = rotation_by({Real(0.3), Real(0.2), Real(0.5)});
      body.angular_velocity = {1, 2, 3};
      add_body(world, body, surface(Box{half}, 0, 1));
      const double before = energy(world);
      Real spin = 0;
      for (int i = 0; i < 2 * hertz; ++i) {
        step(world, 1 / Real(hertz));
        spin = std::max(spin, glm::length(world.bodies[1].angular_velocity));
      }

      // Turns before and after an impact are of second order in the angle of a step;
      // rounding adds one of the energy a step
      const double angle = double(spin) / hertz;
      const double share = angle * angle / 4 + 8.0 * hertz * double(k_u);
      CHECK(std::abs(energy(world) - before) <= share * before);
    }
  }
}

TEST_CASE("micro-collisions settle when the bouncing ball's series ends") {
  for (const Solver& solver : solvers()) {
    INFO(solver.name);
    World world = with_floor(Real(0.5), Real(0.5));
    world.solver = &solver;
    add_body(world, ball(1, Real(0.5), {0, Real(1.5), 0}),
             surface(Sphere{Real(0.5)}, Real(0.5), Real(0.5)));

    // From 1 m it rests after sqrt(2 h / g) (1 + e) / (1 - e) = 1.355 s; worst_first,
    // which sees a contact when it is there, is up to a step late at each of a dozen
    run(world, solver.name == "worst_first" ? 120 : 96);
    CHECK(fastest(world) <= Real(1e-3));
    CHECK(std::abs(world.bodies[1].position.y - Real(0.5)) <= Real(1e-3));
  }
}
