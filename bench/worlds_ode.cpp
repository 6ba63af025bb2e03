// The scenes in the Open Dynamics Engine, as it is by default, with up to four contact
// points a pair and friction that grows with the normal force.
#include <array>
#include <cmath>
#include <stdexcept>

#include <ode/ode.h>

#include "bench/worlds.hpp"

namespace timestep::world_bench {
namespace {

dReal real(double number) {
  return static_cast<dReal>(number);
}

glm::dvec3 vector_of(const dReal* v) {
  return {v[0], v[1], v[2]};
}

// What would end the program ends the simulation
[[noreturn]] void give_up(int, const char*, va_list) {
  throw std::runtime_error("ODE gave up");
}

struct OdeWorld {
  Scene scene;
  dReal dt;
  int (*stepper)(dWorldID, dReal);
  dWorldID world = dWorldCreate();
  dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
  dJointGroupID contacts = dJointGroupCreate(0);
  std::vector<dBodyID> bodies;

  OdeWorld(const Scene& of, const Settings& settings, int (*step_by)(dWorldID, dReal))
      : scene(of), dt(real(settings.dt)), stepper(step_by) {
    dRandSetSeed(1);  // QuickStep shuffles its rows
    const glm::dvec3& g = scene.gravity;
    dWorldSetGravity(world, real(g.x), real(g.y), real(g.z));
    if (settings.iterations > 0)
      dWorldSetQuickStepNumIterations(world, settings.iterations);
    if (settings.erp) dWorldSetERP(world, real(*settings.erp));
    for (Body& body : scene.bodies) add(body);
  }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;
  ~OdeWorld() {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
  }

  void add(Body& body) {
    const dReal mass = real(body.mass), radius = real(body.solid.radius);
    const glm::dvec3 size = 2.0 * body.solid.half_extents;
    const dGeomID geom =
        radius > 0 ? dCreateSphere(space, radius)
                   : dCreateBox(space, real(size.x), real(size.y), real(size.z));
    dGeomSetData(geom, &body);
    bodies.push_back(mass > 0 ? dBodyCreate(world) : nullptr);
    if (mass > 0) {
      dMass all;
      if (radius > 0)
        dMassSetSphereTotal(&all, mass, radius);
      else
        dMassSetBoxTotal(&all, mass, real(size.x), real(size.y), real(size.z));
      dBodySetMass(bodies.back(), &all);
      const glm::dvec3& v = body.velocity;
      dBodySetLinearVel(bodies.back(), real(v.x), real(v.y), real(v.z));
      dGeomSetBody(geom, bodies.back());
    }
    const glm::dvec3& x = body.position;
    const glm::dquat& q = body.orientation;
    const dQuaternion turned{real(q.w), real(q.x), real(q.y), real(q.z)};
    dGeomSetPosition(geom, real(x.x), real(x.y), real(x.z));
    dGeomSetQuaternion(geom, turned);
  }

  static void collide(void* data, dGeomID a, dGeomID b) {
    auto& self = *static_cast<OdeWorld*>(data);
    const dBodyID on_a = dGeomGetBody(a), on_b = dGeomGetBody(b);
    if (on_a == nullptr && on_b == nullptr) return;
    std::array<dContact, 4> found{};
    const int count = dCollide(a, b, 4, &found[0].geom, sizeof(dContact));
    const Body& of_a = *static_cast<const Body*>(dGeomGetData(a));
    const Body& of_b = *static_cast<const Body*>(dGeomGetData(b));
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
      found[i].surface.mode = dContactApprox1 | dContactBounce;
      found[i].surface.mu = real(std::sqrt(of_a.friction * of_b.friction));
      found[i].surface.bounce = real(std::max(of_a.restitution, of_b.restitution));
      dJointAttach(dJointCreateContact(self.world, self.contacts, &found[i]), on_a,
                   on_b);
    }
  }

  void step() {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const glm::dvec3& f = scene.bodies[i].force;
      if (bodies[i] != nullptr)
        dBodyAddForce(bodies[i], real(f.x), real(f.y), real(f.z));
    }
    dSpaceCollide(space, this, collide);
    stepper(world, dt);
    dJointGroupEmpty(contacts);
  }

  std::vector<State> states() const {
    std::vector<State> all;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Body& start = scene.bodies[i];
      all.push_back({start.position, start.orientation, {}, {}});
      if (bodies[i] == nullptr) continue;
      const dReal* const q = dBodyGetQuaternion(bodies[i]);
      all.back() = {vector_of(dBodyGetPosition(bodies[i])),
                    glm::dquat(q[0], q[1], q[2], q[3]),
                    vector_of(dBodyGetLinearVel(bodies[i])),
                    vector_of(dBodyGetAngularVel(bodies[i]))};
    }
    return all;
  }
};

auto by(int (*stepper)(dWorldID, dReal)) {
  return [=](const Scene& scene, const Settings& settings) {
    return simulation<OdeWorld>(scene, settings, stepper);
  };
}

}  // namespace

std::vector<Engine> worlds_of_ode() {
  dInitODE2(0);
  dSetErrorHandler(give_up);
  dSetDebugHandler(give_up);
  dSetMessageHandler([](int, const char*, va_list) {});
  const std::string precision = sizeof(dReal) == 4 ? "/single" : "/double";
  return {
      {.name = "ODE" + precision, .make = by(dWorldQuickStep), .has_erp = true},
      {.name = "ODE_world" + precision, .make = by(dWorldStep), .is_for_few = true}};
}

}  // namespace timestep::world_bench
