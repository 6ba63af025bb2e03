// What surfaces do to slow bodies: static, sliding and rolling friction, and sleep.
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/exact_sliding.hpp"
#include "tests/catch.hpp"
#include "tests/world_scenes.hpp"

using namespace timestep;

namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr std::array k_solvers{"worst_first", "substeps", "sequential_impulses", "lcp"};

// A flat box on a slope, which is the ground under a gravity that leans along x
struct Slope {
  World world;
  BodyHandle box_on_it;

  Slope(const char* solver, Real angle, Real holds, Real slips) {
    const auto rough = [&](const Shape& shape) {
      Collider collider = surface(shape, slips, 0);
      collider.static_friction = holds;
      return collider;
    };
    add_body(world, {}, rough(HalfSpace{{0, 1, 0}, 0}));
    const Vec3 half(Real(0.5), Real(0.1), Real(0.5));
    box_on_it = add_body(world, box(2, half, {0, Real(0.1), 0}), rough(Box{half}));
    world.solver = find_solver(solver);
    world.settings.gravity = k_g * Vec3(std::sin(angle), -std::cos(angle), 0);
  }
};

}  // namespace

TEST_CASE("what does not slip yet is held by static friction, what slips is not") {
  const Real angle = Real(0.45);  // tan = 0.483
  for (const char* solver : k_solvers) {
    INFO(solver);
    Slope at_rest(solver, angle, Real(0.6), Real(0.3));
    run(at_rest.world, 60);

    // worst_first leaves closing speeds of 0.1 mm/s in each step, and their slip
    CHECK(glm::length(body_of(at_rest.world, at_rest.box_on_it).velocity)
          <= Real(1e-3));

    // A push of 1 m/s: friction is that of slip from then on
    Slope pushed(solver, angle, Real(0.6), Real(0.3));
    body_of(pushed.world, pushed.box_on_it).velocity.x = 1;
    run(pushed.world, 60);
    const exact::Incline incline{double(angle), 0.6, 0.3, double(k_g)};
    const double v = exact::on_incline(incline, 1, 1).v;
    CHECK(double(body_of(pushed.world, pushed.box_on_it).velocity.x)
          == Approx(v).epsilon(2e-3));
  }
}

TEST_CASE("one coefficient is both") {
  Slope once("substeps", Real(0.4), 0, Real(0.5)),
      twice("substeps", Real(0.4), Real(0.5), Real(0.5));
  for (Slope* slope : {&once, &twice}) {
    body_of(slope->world, slope->box_on_it).velocity.x = 1;
    run(slope->world, 30);
  }
  CHECK(hash_of(once.world) == hash_of(twice.world));
}

TEST_CASE("rolling friction stops a ball after v² r (1 + k) / 2 rho g") {
  const Real arm = Real(0.005), r = Real(0.2), v = 1;
  for (const char* solver : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(solver);
    World world = with_floor();
    world.solver = find_solver(solver);
    RigidBody body = ball(3, r, {0, r, 0});
    body.velocity.x = v;
    body.angular_velocity.z = -v / r;
    Collider collider = surface(Sphere{r}, Real(0.5), 0);
    collider.rolling_friction = arm;
    const BodyHandle handle = add_body(world, body, collider);
    run(world, 400);

    // The floor's force acts `arm` ahead of the centre. Speeds are linear in time, and
    // so exact; the stop is within a step, of v dt in length at most: here 0.3 mm
    const double stop = double(v * v * r) * (1 + 0.4) / (2 * double(arm) * double(k_g));
    CHECK(double(body_of(world, handle).position.x) == Approx(stop).epsilon(1e-3));
    CHECK(fastest(world) <= 64 * k_u);
  }
}

TEST_CASE("a sleeping world does not move, and wakes at a touch") {
  World world = column_of(3);
  world.sleep.is_on = true;
  run(world, 240);
  const std::uint64_t before = hash_of(world);
  CHECK(fastest(world) == 0);
  run(world, 60);
  CHECK(hash_of(world) == before);
  CHECK(world.contacts.empty());

  // A box that falls on it wakes it all, keeps it awake, and then sleeps with it
  const BodyHandle fallen = add_body(world, box(1, k_half, {Real(0.2), Real(4.5), 0}),
                                     {.shape = Box{k_half}});
  run(world, 30);
  CHECK(world.sleepers.asleep[1] == 0);
  run(world, 300);
  CHECK(world.sleepers.asleep[1] == 1);
  CHECK(world.sleepers.asleep[fallen.index] == 1);
  CHECK(body_of(world, fallen).position.y == Approx(3.5).margin(0.01));

  // So does a force, and what stands below that is taken away
  add_force(world.bodies[2], {1, 0, 0});
  step(world, k_60_hz);
  CHECK(world.sleepers.asleep[2] == 0);
  run(world, 120);
  remove_body(world, {1, 1});
  run(world, 60);
  CHECK(world.bodies[2].position.y == Approx(0.5).margin(0.01));
}

TEST_CASE("sleep keeps mass, and changes nothing until something sleeps") {
  World awake = pile_of(20), sleepy = pile_of(20);
  sleepy.sleep.is_on = true;
  run(awake, 60);
  run(sleepy, 60);
  CHECK(hash_of(awake) == hash_of(sleepy));
  run(sleepy, 600);
  for (std::size_t i = 1; i < sleepy.bodies.size(); ++i)
    CHECK(sleepy.bodies[i].inverse_mass == 1);
}
