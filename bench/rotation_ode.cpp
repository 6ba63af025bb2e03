// The same bodies in the Open Dynamics Engine, with the gyroscopic term that it has by
// default. They have no geometry that could collide.
#include <ode/ode.h>

#include "bench/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

dReal real(double number) {
  return static_cast<dReal>(number);
}

struct World {
  dWorldID world = dWorldCreate();
  std::vector<dBodyID> all;

  // ODE turns a body along the tangent, or by the whole angle if `finite_rotation`
  World(std::span<const glm::dvec3> spins, bool finite_rotation) {
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, real(k_inertia.x), real(k_inertia.y),
                       real(k_inertia.z), 0, 0, 0);
    for (const glm::dvec3& spin : spins) {
      all.push_back(dBodyCreate(world));
      dBodySetMass(all.back(), &mass);
      dBodySetAngularVel(all.back(), real(spin.x), real(spin.y), real(spin.z));
      dBodySetFiniteRotationMode(all.back(), finite_rotation);
    }
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() { dWorldDestroy(world); }

  void step() { dWorldQuickStep(world, real(1.0 / k_steps_a_second)); }
  exact::Turning first() const {
    const dReal *q = dBodyGetQuaternion(all[0]), *omega = dBodyGetAngularVel(all[0]);
    const glm::dquat world_from_body(q[0], q[1], q[2], q[3]);
    return {world_from_body,
            glm::conjugate(world_from_body) * glm::dvec3(omega[0], omega[1], omega[2])};
  }
};

}  // namespace

void add_rotation_with_ode() {
  using Spins = std::span<const glm::dvec3>;
  dInitODE2(0);
  const std::string precision = sizeof(dReal) == 4 ? "/single" : "/double";
  add_bodies("ODE" + precision, [](Spins spins) { return World(spins, false); });
  add_bodies("ODE_finite_rotation" + precision,
             [](Spins spins) { return World(spins, true); });
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
