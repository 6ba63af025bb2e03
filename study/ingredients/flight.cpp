#include "study/ingredients/flight.hpp"

#include <array>
#include <memory>
#include <numbers>

#include "common/physics/exact.hpp"
#include "common/physics/exact_free_top.hpp"
#include "common/physics/gyroscopic.hpp"
#include "common/physics/mass_properties.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/rigid_body.hpp"
#include "common/physics/rotation_momentum.hpp"
#include "common/physics/runge_kutta.hpp"
#include "common/physics/swarm.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {
namespace {

using study::Comparison;
using study::Motion;

// Bodies that are all alike, as many as it takes to time a step
constexpr int k_copies = 64, k_swarm = 1024;
constexpr double k_dt = 1.0 / 60;
const glm::dvec3 k_g(0, -9.81, 0);

// --- drag ----------------------------------------------------------------------------

struct Flight {
  Swarm<2> balls;
  exact::Motion start;
  long long steps = 0;
};

std::shared_ptr<Flight> flight_from(const exact::Motion& start) {
  State state = particles(k_swarm);
  for (std::size_t i = 0; i < k_swarm; ++i) {
    put(state.x, i, Vec3(start.x));
    put(state.v, i, Vec3(start.v));
  }
  return std::make_shared<Flight>(Flight{swarm_of<2>(state), start});
}

glm::dvec3 place_of(const Particle& ball) {
  return {ball.x[0], ball.x[1], ball.x[2]};
}

// By rk4
Motion flying(const exact::Motion& start, const auto& accelerate, const auto& exact) {
  auto flight = flight_from(start);
  return {[=] {
            // A copy that nothing else refers to, so that it stays in registers
            for_each(flight->balls, [own = accelerate](Particle& ball) {
              std::array<Particle, 3> stages;
              rk4(ball, Stages<Particle>(stages), own, 0, Real(k_dt));
            });
            ++flight->steps;
          },
          [=] {
            const double t = k_dt * double(flight->steps);
            return glm::distance(place_of(load(flight->balls.packs[0], 0)),
                                 exact(flight->start, t).x);
          }};
}

const auto k_free_fall = [](const auto&, const auto&, Real, const auto& a) {
  a[0] = a[2] = 0;
  a[1] = Real(-9.81);
};

// A ball of 40 mm in air of 1.2 kg/m³ with C_d = 0.47, by its mass [kg]: k / m [1/m]
double drag_per_mass(double mass) {
  constexpr double k_radius = 0.02;
  return 1.2 * 0.47 * std::numbers::pi * k_radius * k_radius / 2 / mass;
}

Comparison drag(double mass, const exact::Motion& start) {
  const double k = drag_per_mass(mass);
  const auto exact = [k](const exact::Motion& from, double t) {
    return exact::quadratic_drag(from, k_g, k, t);
  };
  const auto in_air = [k = Real(k)](const auto&, const auto& v, Real, const auto& a) {
    const Vec3 drag = quadratic_drag(k, Vec3(v[0], v[1], v[2]));
    a[0] = drag.x;
    a[1] = drag.y + Real(-9.81);
    a[2] = drag.z;
  };
  return {.ingredient = "drag",
          .metric = "place",
          .unit = "m",
          .exact = "quadratic drag in closed form",
          .bodies = k_swarm,
          .with = {"quadratic drag", [=] { return flying(start, in_air, exact); }},
          .without = {"no drag", [=] { return flying(start, k_free_fall, exact); }}};
}

// --- rotation ------------------------------------------------------------------------

const auto k_no_torque = [](const Quat&, Real) { return Vec3(0); };

struct Tumbling {
  std::array<RigidBody, k_copies> bodies;
  long long steps = 0;
};

// Modified Euler, exact in free fall; the turn beside it, if asked for
template <bool turns>
void fly(RigidBody& body) {
  constexpr Real k_h = Real(k_dt);
  body.position += k_h * (body.velocity + k_h / 2 * Vec3(k_g));
  body.velocity += k_h * Vec3(k_g);
  if constexpr (turns) {
    Rotation r = rotation_of(body);
    buss(r, Vec3(1) / body.inverse_inertia, k_no_torque, 0, k_h);
    set_rotation(body, r);
  }
}

template <bool turns>
Motion thrown_bar() {
  RigidBody bar;
  bar.velocity = {3, 6, 0};
  bar.angular_velocity = {1, 2, 8};
  const Mat3 inertia = solid_box(1, {Real(0.3), Real(0.06), Real(0.02)}).inertia;
  bar.inverse_mass = 1;
  bar.inverse_inertia = Vec3(1) / Vec3(inertia[0][0], inertia[1][1], inertia[2][2]);
  auto now = std::make_shared<Tumbling>();
  now->bodies.fill(bar);
  return {
      [=] {
        for (RigidBody& body : now->bodies) fly<turns>(body);
        ++now->steps;
      },
      [=] {
        const exact::Motion start{glm::dvec3(bar.position), glm::dvec3(bar.velocity)};
        const double t = k_dt * double(now->steps);
        return glm::distance(glm::dvec3(now->bodies[0].position),
                             exact::constant_acceleration(start, k_g, t).x);
      }};
}

// --- gyroscopic term and inertia tensor ----------------------------------------------

using Turn = void (*)(Rotation& r, const Vec3& I);

void turn_with_term(Rotation& r, const Vec3& I) {
  buss(r, I, k_no_torque, 0, Real(k_dt));
}

void turn_without_term(Rotation& r, const Vec3& I) {
  constant_omega(r, I, k_no_torque, 0, Real(k_dt));
}

// A body whose principal moments are modelled as `I`, while `exact` turns
Motion turning(const Vec3& I, const Vec3& omega, Turn turn, const glm::dvec3& moments,
               const exact::Turning& exact) {
  struct Spin {
    std::array<Rotation, k_copies> bodies;
    long long steps = 0;
  };
  auto now = std::make_shared<Spin>();
  now->bodies.fill({.omega = omega});
  return {[=] {
            for (Rotation& body : now->bodies) turn(body, I);
            ++now->steps;
          },
          [=] {
            const double t = k_dt * double(now->steps);
            return exact::angle_between(exact::free_top(moments, exact, t).q,
                                        glm::dquat(now->bodies[0].q));
          }};
}

Vec3 box_moments(const glm::dvec3& size) {
  const Mat3 inertia = solid_box(1, Vec3(size)).inertia;
  return {inertia[0][0], inertia[1][1], inertia[2][2]};
}

Comparison spin(const std::string& scene, bool matters, const glm::dvec3& size,
                const glm::dvec3& omega) {
  const Vec3 I = box_moments(size);
  const auto start = [=](Turn turn) {
    return turning(I, Vec3(omega), turn, glm::dvec3(I),
                   {glm::dquat(1, 0, 0, 0), omega});
  };
  return {
      .ingredient = "gyroscopic term",
      .scene = scene,
      .matters = matters,
      .metric = "attitude",
      .unit = "rad",
      .exact = "Jacobi's elliptic functions",
      .steps = 120,
      .bodies = k_copies,
      .with = {"Buss's method", [=] { return start(turn_with_term); }},
      .without = {"angular velocity kept", [=] { return start(turn_without_term); }}};
}

// A box of 1 kg at rest, met by 0.1 N s along y at the middle of its right end
Comparison struck(const std::string& scene, bool matters, const glm::dvec3& size) {
  const Vec3 I = box_moments(size);
  const Vec3 ball(Real((I.x + I.y + I.z) / 3));
  const glm::dvec3 momentum(0, 0, size.x / 2 * 0.1);
  const exact::Turning exact{glm::dquat(1, 0, 0, 0), momentum / glm::dvec3(I)};
  const auto start = [=](const Vec3& modelled, Turn turn) {
    return turning(modelled, Vec3(momentum) / modelled, turn, glm::dvec3(I), exact);
  };
  return {.ingredient = "inertia tensor",
          .scene = scene,
          .matters = matters,
          .metric = "attitude",
          .unit = "rad",
          .exact = "J a t / I",
          .steps = 60,
          .bodies = k_copies,
          .with = {"tensor", [=] { return start(I, turn_with_term); }},
          .without = {"sphere of the mean moment",
                      [=] { return start(ball, turn_without_term); }}};
}

}  // namespace

Motion thrown_ball(double from) {
  const double v = 10 / std::numbers::sqrt2;
  const auto exact = [](const exact::Motion& start, double t) {
    return exact::constant_acceleration(start, k_g, t);
  };
  return flying({{from, 0, 0}, {v, v, 0}}, k_free_fall, exact);
}

std::vector<Comparison> flight_comparisons() {
  const double v = 10 / std::numbers::sqrt2;
  Comparison light = drag(0.0027, {{0, 0, 0}, {v, v, 0}});
  light.scene = "ping-pong ball thrown at 10 m/s";
  light.matters = true;
  light.steps = 60;
  Comparison heavy = drag(0.263, {{0, 1, 0}, {0, 0, 0}});
  heavy.scene = "steel ball of that size dropped from 1 m";
  heavy.matters = false;
  heavy.steps = 27;

  Comparison centre{.ingredient = "rotation",
                    .scene = "centre of a thrown bar",
                    .matters = false,
                    .metric = "place",
                    .unit = "m",
                    .exact = "free fall",
                    .steps = 60,
                    .bodies = k_copies,
                    .with = {"rigid body", thrown_bar<true>},
                    .without = {"particle", thrown_bar<false>}};
  return {light,
          heavy,
          centre,
          spin("thrown book, spun about its middle axis", true, {0.2, 0.3, 0.04},
               {5, 0.05, 0.05}),
          spin("thrown die", false, {0.02, 0.02, 0.02}, {5, 3, 20}),
          struck("bar struck at its end", true, {1, 0.1, 0.1}),
          struck("cube struck off its centre", false, {0.4, 0.4, 0.4})};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
