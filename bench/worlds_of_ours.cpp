// The scenes in our own world, by each of its solvers.
#include <limits>

#include "bench/worlds.hpp"
#include "common/physics/mass_properties.hpp"
#include "common/physics/world.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

using world_bench::Engine;
using world_bench::Scene;
using world_bench::Settings;
using world_bench::State;

constexpr bool k_single = std::numeric_limits<Real>::digits == 24;

RigidBody rigid_body(const world_bench::Body& body) {
  const auto mass = Real(body.mass);
  const Vec3 size = Vec3(2.0 * body.solid.half_extents);
  RigidBody made;
  if (mass > 0 && body.solid.radius > 0)
    made = body_with_mass(mass, solid_sphere(mass, Real(body.solid.radius)).inertia);
  else if (mass > 0)
    made = body_with_mass(mass, solid_box(mass, size).inertia);
  made.position = Vec3(body.position);
  made.orientation = Quat(body.orientation);
  made.velocity = Vec3(body.velocity);
  return made;
}

Collider collider(const world_bench::Body& body) {
  Collider made;
  made.shape = Box{Vec3(body.solid.half_extents)};
  if (body.solid.radius > 0) made.shape = Sphere{Real(body.solid.radius)};
  made.friction = Real(body.friction);
  made.restitution = Real(body.restitution);
  return made;
}

struct Ours {
  Scene scene;
  Real dt;
  World world;

  Ours(const Scene& of, const Settings& settings, const Solver* solver)
      : scene(of), dt(Real(settings.dt)) {
    world.solver = solver;
    world.settings.gravity = Vec3(scene.gravity);
    if (settings.iterations > 0) {
      world.settings.substeps = settings.iterations;
      world.settings.iterations = settings.iterations;
      world.settings.contacts_at_most = settings.iterations;
    }
    for (const world_bench::Body& body : scene.bodies)
      add_body(world, rigid_body(body), collider(body));
  }
  void step() {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      add_force(world.bodies[i], Vec3(scene.bodies[i].force));
    timestep::step(world, dt);
  }
  std::vector<State> states() const {
    std::vector<State> all;
    for (const RigidBody& body : world.bodies)
      all.push_back({glm::dvec3(body.position), glm::dquat(body.orientation),
                     glm::dvec3(body.velocity), glm::dvec3(body.angular_velocity)});
    return all;
  }
};

}  // namespace

// In single the default alone
std::vector<Engine> worlds_of_ours() {
  std::vector<Engine> all;
  for (const Solver& solver : solvers()) {
    if (k_single && solver.name != World{}.solver->name) continue;
    const auto make = [&solver](const Scene& scene, const Settings& settings) {
      return world_bench::simulation<Ours>(scene, settings, &solver);
    };
    all.push_back(
        {.name = std::string(solver.name) + (k_single ? "/single" : "/double"),
         .make = make,
         .is_for_few = solver.name == "lcp"});
  }
  return all;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
