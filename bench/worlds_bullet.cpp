// The scenes in Bullet, as it is by default; no body sleeps.
#include <cmath>
#include <deque>

#include <btBulletDynamicsCommon.h>

#include "bench/worlds.hpp"

namespace timestep::world_bench {
namespace {

btScalar scalar(double number) {
  return static_cast<btScalar>(number);
}

btVector3 bullet_vector(const glm::dvec3& v) {
  return {scalar(v.x), scalar(v.y), scalar(v.z)};
}

glm::dvec3 vector_of(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

std::unique_ptr<btCollisionShape> shape_of(const Solid& solid) {
  if (solid.radius > 0) return std::make_unique<btSphereShape>(scalar(solid.radius));
  return std::make_unique<btBoxShape>(bullet_vector(solid.half_extents));
}

struct BulletWorld {
  Scene scene;
  btScalar dt;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::deque<btRigidBody> bodies;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

  BulletWorld(const Scene& of, const Settings& settings)
      : scene(of), dt(scalar(settings.dt)) {
    btContactSolverInfo& info = world.getSolverInfo();
    if (settings.iterations > 0) info.m_numIterations = settings.iterations;
    if (settings.erp) info.m_erp = info.m_erp2 = scalar(*settings.erp);
    world.setGravity(bullet_vector(scene.gravity));
    for (const Body& body : scene.bodies) add(body);
  }

  // A pair has the product of what its surfaces have: of the roots the mean, or what
  // both have
  void add(const Body& body) {
    shapes.push_back(shape_of(body.solid));
    btVector3 inertia(0, 0, 0);
    if (body.mass > 0) shapes.back()->calculateLocalInertia(scalar(body.mass), inertia);
    btRigidBody& made =
        bodies.emplace_back(scalar(body.mass), nullptr, shapes.back().get(), inertia);
    const glm::dquat& q = body.orientation;
    const btQuaternion turned(scalar(q.x), scalar(q.y), scalar(q.z), scalar(q.w));
    made.setWorldTransform(btTransform(turned, bullet_vector(body.position)));
    made.setInterpolationWorldTransform(made.getWorldTransform());
    made.setLinearVelocity(bullet_vector(body.velocity));
    made.setFriction(scalar(std::sqrt(body.friction)));
    made.setRestitution(scalar(std::sqrt(body.restitution)));
    made.setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(&made);
  }

  void step() {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      bodies[i].applyCentralForce(bullet_vector(scene.bodies[i].force));
    world.stepSimulation(dt, 0);
  }

  std::vector<State> states() const {
    std::vector<State> all;
    for (const btRigidBody& body : bodies) {
      const btQuaternion q = body.getOrientation();
      all.push_back({vector_of(body.getWorldTransform().getOrigin()),
                     glm::dquat(q.w(), q.x(), q.y(), q.z()),
                     vector_of(body.getLinearVelocity()),
                     vector_of(body.getAngularVelocity())});
    }
    return all;
  }
};

}  // namespace

std::vector<Engine> worlds_of_bullet() {
  const std::string precision = sizeof(btScalar) == 4 ? "/single" : "/double";
  const auto make = [](const Scene& scene, const Settings& settings) {
    return simulation<BulletWorld>(scene, settings);
  };
  return {{.name = "Bullet" + precision, .make = make, .has_erp = true}};
}

}  // namespace timestep::world_bench
