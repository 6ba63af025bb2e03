// Worlds that fall, bounce, slide and come to rest, by every solver.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/allocations.hpp"
#include "tests/catch.hpp"
#include "tests/world_scenes.hpp"

using namespace timestep;

namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

// Of the pile below after ten seconds
constexpr std::uint64_t k_hash_single = 0x23f9657282d4259f;
constexpr std::uint64_t k_hash_double = 0xdf0e3b0a4fca05e4;

}  // namespace

TEST_CASE("a ball that loses nothing bounces on for ever") {
  for (const char* solver : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(solver);
    World world = with_floor(Real(0.5), 1);
    world.solver = find_solver(solver);
    add_body(world, ball(1, Real(0.5), {0, 3, 0}),
             surface(Sphere{Real(0.5)}, Real(0.5), 1));
    const double rest = double(k_g) * 0.5, before = energy(world) - rest;
    run(world, 600);

    // The time of impact is solved for, so what is lost is rounding: 2400 substeps of a
    // dozen operations each on numbers of the energy's size
    CHECK(std::abs(energy(world) - rest - before) <= 12 * 2400 * double(k_u) * before);
  }
}

TEST_CASE("restitution is the ratio of the speeds") {
  for (const Real e : {Real(0.25), Real(0.5), Real(0.75)}) {
    World world = with_floor(Real(0.5), e);
    const auto handle = add_body(world, ball(1, Real(0.5), {0, Real(1.5), 0}),
                                 surface(Sphere{Real(0.5)}, Real(0.5), e));
    Real highest = 0;
    for (int i = 0; i < 120; ++i) {
      step(world, k_60_hz);
      const RigidBody& body = body_of(world, handle);
      const Real up = std::max(body.velocity.y, Real(0));
      const bool first = Real(i) * k_60_hz < std::sqrt(2 / k_g) * (1 + e);
      if (first && up > 0)
        highest = std::max(highest, body.position.y + up * up / (2 * k_g));
    }
    CHECK(std::abs(highest - Real(0.5) - e * e) <= 12 * 480 * k_u);
  }
}

TEST_CASE("a sliding block stops where Coulomb's law says") {
  for (const char* solver : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(solver);
    World world = with_floor(Real(0.5));
    world.solver = find_solver(solver);
    RigidBody block = box(1, {Real(0.5), Real(0.25), Real(0.5)}, {0, Real(0.25), 0});
    block.velocity = {3, 0, 4};
    const auto handle = add_body(
        world, block, surface(Box{{Real(0.5), Real(0.25), Real(0.5)}}, Real(0.5), 0));
    run(world, 180);
    const double path =
        double(glm::length(body_of(world, handle).position
                           - Vec3(0, body_of(world, handle).position.y, 0)));
    const double exact = 25 / (2 * 0.5 * double(k_g));
    CHECK(std::abs(path - exact) <= 5e-4 * exact);  // the aim
    CHECK(fastest(world) <= Real(1e-5));
  }
}

TEST_CASE("an elastic gas keeps its energy") {
  World world;
  world.settings.gravity = Vec3(0);
  for (const int side : {-1, 1}) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3 outward(0);
      outward[axis] = Real(side);
      RigidBody wall;
      wall.position = outward;
      add_body(world, wall, surface(HalfSpace{-outward, 0}, 0, 1));
    }
  }
  for (int i = 0; i < 64; ++i) {
    const int row = i / 4 % 4, layer = i / 16;
    const Vec3 place = Vec3(Real(i % 4), Real(row), Real(layer)) - Vec3(Real(1.5));
    RigidBody body = ball(1, Real(0.1), Real(0.45) * place);
    body.velocity =
        Vec3(std::sin(Real(i)), std::cos(Real(2 * i)), std::sin(Real(3 * i)));
    add_body(world, body, surface(Sphere{Real(0.1)}, 0, 1));
  }
  const double before = energy(world);
  run(world, 2000, Real(0.001));

  // Sweeps over impacts that meet in one substep converge to 1e-6 of their speeds at
  // worst; rounding adds 8000 substeps
  CHECK(std::abs(energy(world) - before) <= (1e-6 + 8000 * double(k_u)) * before);
}

TEST_CASE("two blocks with a push and a twist come to rest on the floor") {
  World world = with_floor(Real(0.5), Real(0.3));
  const Vec3 first(Real(0.5), Real(0.3), Real(0.4)),
      second(Real(0.3), Real(0.5), Real(0.4));
  RigidBody a = box(1, first, {0, 3, 0});
  RigidBody b = box(2, second, {Real(0.2), Real(4.5), Real(0.1)});
  add_force(a, {20, 0, 10});
  add_torque(a, {0, 30, 50});
  add_force(b, {-50, 0, 20});
  add_torque(b, {40, 0, -30});
  add_body(world, a, surface(Box{first}, Real(0.5), Real(0.3)));
  add_body(world, b, surface(Box{second}, Real(0.5), Real(0.3)));
  run(world, 600);
  CHECK(deepest(world) < Real(1e-3));
  CHECK(fastest(world) < Real(1e-4));
}

TEST_CASE("a column of ten boxes stands for a minute") {
  World world = column_of(10);
  run(world, 3600);
  const RigidBody& top = world.bodies.back();
  CHECK(std::hypot(top.position.x, top.position.z) < Real(0.25));
  CHECK(top.position.y > Real(9.45));
  CHECK(deepest(world) < Real(5e-3));
  CHECK(fastest(world) < Real(1e-4));
}

TEST_CASE("a pyramid stands") {
  World world = pyramid_of(10);
  const Vec3 before = world.bodies.back().position;
  run(world, 600);
  CHECK(glm::length(world.bodies.back().position - before) < Real(0.03));
  CHECK(deepest(world) < Real(3e-3));
}

TEST_CASE("by every solver a box comes to rest") {
  for (const Solver& solver : solvers()) {
    INFO(solver.name);
    World world = with_floor();
    world.solver = &solver;
    const auto handle =
        add_body(world, box(1, k_half, {0, Real(0.7), 0}), {.shape = Box{k_half}});
    run(world, 120);
    CHECK(std::abs(body_of(world, handle).position.y - Real(0.5)) < Real(1e-3));
    CHECK(fastest(world) < Real(1e-3));
  }
}

TEST_CASE("every contact of a pile obeys Coulomb's bound") {
  World world = pile_of(50);
  for (int i = 0; i < 200; ++i) {
    step(world, k_60_hz);
    for (const ContactRow& row : world.room.rows) {
      const Real most = row.friction * row.normal_impulse;
      CHECK(row.normal_impulse >= 0);
      CHECK(glm::length(row.tangent_impulse) <= most * (1 + 8 * k_u));
    }
  }
}

TEST_CASE("what collides in the air keeps its momentum") {
  World world = pile_of(50);
  world.settings.gravity = Vec3(0);
  remove_body(world, {0, 1});
  Vec3 before(0), now(0);
  Real size = 0;
  for (RigidBody& body : world.bodies) {
    if (body.inverse_mass == 0) continue;
    body.velocity = Vec3(3, 4, 3) - body.position;
    before += body.velocity;
    size += glm::length(body.velocity);
  }
  run(world, 120);
  CHECK(fastest(world) > 0);
  for (const RigidBody& body : world.bodies) now += body.velocity;

  // Each of 120 x 8 sweeps over some hundred contacts rounds velocities of a few m/s,
  // as random as a walk: sqrt(960 x 100) = 310, twice
  CHECK(glm::length(now - before) <= 2 * 310 * k_u * size);
}

TEST_CASE("two runs end in the same bits, by gcc and by clang") {
  World first = pile_of(100), second = pile_of(100);
  run(first, 600);
  run(second, 600);
  CHECK(hash_of(first) == hash_of(second));
  const std::uint64_t locked_in = sizeof(Real) == 4 ? k_hash_single : k_hash_double;
  CHECK(hash_of(first) == locked_in);
}

TEST_CASE("a settled step allocates nothing") {
  for (const char* solver : {"worst_first", "sequential_impulses", "substeps"}) {
    INFO(solver);
    World world = column_of(5);
    world.solver = find_solver(solver);
    run(world, 120);
    const int before = allocations;
    run(world, 10);
    CHECK(allocations == before);
  }
}

TEST_CASE("bad bodies, shapes, steps and handles are refused in words") {
  World world = with_floor();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Collider good{.shape = Box{k_half}};
  const RigidBody fine = box(1, k_half, {0, 5, 0});
  for (const Real bad : {nan, std::numeric_limits<Real>::infinity(), Real(-1)}) {
    RigidBody body = fine;
    body.inverse_mass = bad;
    CHECK_THROWS_AS(add_body(world, body, good), WorldError);
    CHECK_THROWS_AS(add_body(world, fine, surface(Sphere{bad}, 0, 0)), WorldError);
    CHECK_THROWS_AS(add_body(world, fine, surface(Box{k_half}, bad, 0)), WorldError);
    CHECK_THROWS_AS(add_body(world, fine, surface(Box{k_half}, 0, bad)), WorldError);
    CHECK_THROWS_AS(step(world, bad), WorldError);
  }
  for (const Real mass : {Real(0), Real(-1), nan})
    CHECK_THROWS_AS(add_body(world, body_with_mass(mass, Mat3(mass)), good),
                    WorldError);
  for (Real Collider::*const friction :
       {&Collider::static_friction, &Collider::rolling_friction}) {
    Collider rough = good;
    rough.*friction = -1;
    CHECK_THROWS_WITH(add_body(world, fine, rough), "a friction is negative");
  }
  CHECK_THROWS_AS(add_body(world, fine, surface(Capsule{1, 0}, 0, 0)), WorldError);
  CHECK_THROWS_AS(step(world, 0), WorldError);
  world.settings.gravity.x = nan;
  CHECK_THROWS_WITH(step(world, k_60_hz), "gravity is not finite");
  world.settings.gravity.x = 0;
  CHECK(world.bodies.size() == 1);

  const BodyHandle handle = add_body(world, fine, good);
  remove_body(world, handle);
  CHECK_THROWS_AS(body_of(world, handle), WorldError);
  CHECK_THROWS_AS(remove_body(world, handle), WorldError);
  const BodyHandle other = add_body(world, fine, good);
  CHECK(other.index == handle.index);
  CHECK_THROWS_AS(body_of(world, handle), WorldError);
  CHECK(body_of(world, other).position == fine.position);

  body_of(world, other).velocity.x = nan;
  CHECK_THROWS_WITH(step(world, k_60_hz), "body 1: a velocity is not finite");
}

TEST_CASE("settings that are no numbers, or negative, are refused by their names") {
  const auto refused = [](auto change, const std::string& words) {
    for (const Real bad : {Real(-1), std::numeric_limits<Real>::quiet_NaN(),
                           std::numeric_limits<Real>::infinity()}) {
      World world = column_of(1);
      change(world) = bad;
      CHECK_THROWS_WITH(step(world, k_60_hz), words + " is negative or not finite");
      CHECK(world.bodies[1].position == Vec3(0, Real(0.5), 0));
    }
  };
  refused([](World& w) -> Real& { return w.margin; }, "margin");
  refused([](World& w) -> Real& { return w.settings.contact_frequency; },
          "contact_frequency");
  refused([](World& w) -> Real& { return w.settings.damping_ratio; }, "damping_ratio");
  refused([](World& w) -> Real& { return w.settings.push_speed; }, "push_speed");
  refused([](World& w) -> Real& { return w.settings.restitution_threshold; },
          "restitution_threshold");
  refused([](World& w) -> Real& { return w.settings.static_speed; }, "static_speed");
  refused([](World& w) -> Real& { return w.settings.velocity_epsilon; },
          "velocity_epsilon");
  refused([](World& w) -> Real& { return w.penetration.epsilon; }, "epsilon");
  refused([](World& w) -> Real& { return w.penetration.slop; }, "slop");
  refused([](World& w) -> Real& { return w.penetration.beta; }, "beta");
  refused([](World& w) -> Real& { return w.sleep.speed; }, "sleep.speed");

  World world = column_of(1);
  world.settings.iterations = -1;
  CHECK_THROWS_WITH(step(world, k_60_hz), "a number of iterations is negative");
  world.settings.iterations = 1;
  world.settings.substeps = 0;
  CHECK_THROWS_WITH(step(world, k_60_hz), "there are no substeps");
}
