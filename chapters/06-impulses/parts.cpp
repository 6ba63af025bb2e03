#include "chapters/06-impulses/parts.hpp"

#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

std::vector<Method> all_choices() {
  std::vector<Method> all;
  for (const Solver& solver : solvers())
    all.push_back({std::string(solver.name), std::string(solver.summary),
                   method_style(static_cast<int>(all.size()))});
  return all;
}

std::vector<Parameter> with_settings(std::vector<Parameter> own, double gravity) {
  const std::vector<Parameter> shared{
      {"gravity", "m/s²", "downwards", gravity, 0, 1000},
      {"substeps", "", "of the method substeps, in a step", 4, 1, 1000, true},
      {"iterations", "", "sweeps; of worst_first, impacts in hundreds", 10, 1, 1000,
       true},
      {"law", "",
       "of impact, for worst_first: 0 frictionless, 1 sequential_friction, 2 "
       "coupled_friction, 3 poisson",
       2, 0, 3, true},
      {"way_out", "",
       "of penetrations, where contacts are hard: 0 linear_projection, 1 worst_first, "
       "2 baumgarte, 3 split_impulse, 4 ngs",
       4, 0, 4, true},
      {"threshold", "m/s", "slower impacts do not bounce", 0, 0, 10},
      {"origin", "m", "of the world from the scene, along x", 0, -1e12, 1e12},
  };
  own.insert(own.end(), shared.begin(), shared.end());
  return own;
}

World world_of(const Setup& setup) {
  const auto& p = setup.parameters;
  const auto integer = [&](const char* name) { return static_cast<int>(p.at(name)); };
  const auto index = [&](const char* name) {
    return static_cast<std::size_t>(p.at(name));
  };
  World world;
  world.solver = find_solver(setup.method);
  world.impact_law = &impact_laws()[index("law")];
  world.out_of_penetration = &penetration_methods()[index("way_out")];
  world.settings.gravity = {0, -Real(p.at("gravity")), 0};
  world.settings.substeps = integer("substeps");
  world.settings.iterations = integer("iterations");
  world.settings.contacts_at_most = 100 * integer("iterations");
  world.settings.restitution_threshold = Real(p.at("threshold"));
  return world;
}

RigidBody box_body(double mass, const glm::dvec3& size, const glm::dvec3& position) {
  RigidBody body =
      body_with_mass(Real(mass), solid_box(Real(mass), Vec3(size)).inertia);
  body.position = Vec3(position);
  return body;
}

RigidBody ball_body(double mass, double radius, const glm::dvec3& position) {
  RigidBody body =
      body_with_mass(Real(mass), solid_sphere(Real(mass), Real(radius)).inertia);
  body.position = Vec3(position);
  return body;
}

namespace {

Collider collider_of(const Shape& shape, double friction, double restitution) {
  Collider collider;
  collider.shape = shape;
  collider.friction = Real(friction);
  collider.restitution = Real(restitution);
  return collider;
}

}  // namespace

Collider box_collider(const glm::dvec3& size, double friction, double restitution) {
  return collider_of(Box{Vec3(size) / Real(2)}, friction, restitution);
}

Collider ball_collider(double radius, double friction, double restitution) {
  return collider_of(Sphere{Real(radius)}, friction, restitution);
}

Collider floor_collider(double friction, double restitution) {
  return collider_of(HalfSpace{{0, 1, 0}, 0}, friction, restitution);
}

double kinetic_energy_of(const World& world) {
  double sum = 0;
  for (const RigidBody& body : world.bodies) sum += kinetic_energy(body);
  return sum;
}

double energy_of(const World& world) {
  double sum = 0;
  const glm::dvec3 g(world.settings.gravity);
  for (const RigidBody& body : world.bodies)
    sum +=
        kinetic_energy(body) - mass_of(body) * glm::dot(g, glm::dvec3(body.position));
  return sum;
}

glm::dvec3 momentum_of(const World& world) {
  glm::dvec3 sum(0);
  for (const RigidBody& body : world.bodies)
    sum += mass_of(body) * glm::dvec3(body.velocity);
  return sum;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
