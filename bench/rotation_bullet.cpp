// The same bodies in Bullet, with the gyroscopic term that it has by default and
// without damping, sleep and collision detection.
#include <deque>

#include <btBulletDynamicsCommon.h>

#include "bench/rotation.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

constexpr btScalar k_dt = btScalar(1) / k_steps_a_second;

btVector3 bullet_vector(const glm::dvec3& v) {
  return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}

// Bodies without a world: of what the world does to a body, only what moves a free one,
// once each
struct FreeBodies {
  btEmptyShape shape;
  std::deque<btRigidBody> all;

  explicit FreeBodies(std::span<const glm::dvec3> spins) {
    for (const glm::dvec3& spin : spins) {
      all.emplace_back(btScalar(1), nullptr, &shape, bullet_vector(k_inertia));
      all.back().setAngularVelocity(bullet_vector(spin));
      all.back().setActivationState(DISABLE_DEACTIVATION);
    }
  }
  void step() {
    btTransform next;
    for (btRigidBody& body : all) {
      const btVector3 change = body.computeGyroscopicImpulseImplicit_Body(k_dt);
      body.setAngularVelocity(body.getAngularVelocity() + change);
      body.predictIntegratedTransform(k_dt, next);
      body.proceedToTransform(next);
    }
  }
  exact::Turning first() const {
    const btQuaternion q = all[0].getOrientation();
    const btVector3& omega = all[0].getAngularVelocity();
    const glm::dquat world_from_body(q.w(), q.x(), q.y(), q.z());
    return {world_from_body, glm::conjugate(world_from_body)
                                 * glm::dvec3(omega.x(), omega.y(), omega.z())};
  }
};

struct WorldWithoutCollisions : btDiscreteDynamicsWorld {
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  void performDiscreteCollisionDetection() override {}
};

struct BodiesInWorld {
  FreeBodies bodies;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btSimpleBroadphase broadphase;  // only keeps a list of the bodies
  btSequentialImpulseConstraintSolver solver;
  WorldWithoutCollisions world{&dispatcher, &broadphase, &solver, &configuration};

  explicit BodiesInWorld(std::span<const glm::dvec3> spins)
      : bodies(spins), broadphase(static_cast<int>(spins.size())) {
    world.setGravity({0, 0, 0});
    for (btRigidBody& body : bodies.all) world.addRigidBody(&body, 0, 0);
  }
  void step() { world.stepSimulation(k_dt, 0); }
  exact::Turning first() const { return bodies.first(); }
};

}  // namespace

void add_rotation_with_bullet() {
  using Spins = std::span<const glm::dvec3>;
  const std::string precision = sizeof(btScalar) == 4 ? "/single" : "/double";
  add_bodies("Bullet_bodies" + precision,
             [](Spins spins) { return FreeBodies(spins); });
  add_bodies("Bullet_world" + precision,
             [](Spins spins) { return BodiesInWorld(spins); });
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
