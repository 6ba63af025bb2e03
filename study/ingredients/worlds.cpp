#include "study/ingredients/worlds.hpp"

#include <memory>

#include "common/physics/mass_properties.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {
namespace {

std::size_t add(World& world, RigidBody body, const glm::dvec3& place,
                const Collider& collider) {
  body.position = Vec3(place);
  return add_body(world, body, collider).index;
}

}  // namespace

World ground(const Collider& surface) {
  World world;
  Collider collider = surface;
  collider.shape = HalfSpace{{0, 1, 0}, 0};
  add_body(world, {}, collider);
  world.settings.gravity = {0, Real(-k_gravity), 0};
  return world;
}

std::size_t add_ball(World& world, double mass, double radius, const glm::dvec3& place,
                     Collider surface) {
  const Real m = Real(mass), r = Real(radius);
  surface.shape = Sphere{r};
  return add(world, body_with_mass(m, solid_sphere(m, r).inertia), place, surface);
}

std::size_t add_box(World& world, double mass, const glm::dvec3& size,
                    const glm::dvec3& place, Collider surface) {
  const Real m = Real(mass);
  surface.shape = Box{Vec3(size / 2.0)};
  return add(world, body_with_mass(m, solid_box(m, Vec3(size)).inertia), place,
             surface);
}

study::Motion moving(const World& world, const ErrorOf& error) {
  return moving(world, error, [](World& now) { step(now, Real(k_dt)); });
}

study::Motion moving(const World& world, const ErrorOf& error, const WorldStep& step) {
  struct Run {
    World world;
    long long steps = 0;
  };
  auto run = std::make_shared<Run>(Run{world});
  return {[=] {
            step(run->world);
            ++run->steps;
          },
          [=] { return error(run->world, k_dt * double(run->steps)); }};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
