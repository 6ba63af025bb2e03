// Chapter 3's rigid bodies: forces at points, frames, and the step. Compiled for each
// precision; u (k_u) is the unit round-off of the one at hand.
#include <cmath>

#include "common/physics/gyroscopic.hpp"
#include "common/physics/rigid_body.hpp"
#include "common/physics/rotation_momentum.hpp"
#include "tests/rotation_run.hpp"

using namespace timestep;

namespace {

RigidBody brick() {
  return {.position = {1, -2, 3},
          .orientation = tumbling().q,
          .velocity = {Real(0.5), 4, -1},
          .angular_velocity = {2, -1, Real(0.5)},
          .inverse_mass = Real(0.5),
          .inverse_inertia = {Real(0.5), 2, 1}};
}

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double largest(const Mat3& m) {
  return std::max({largest(m[0]), largest(m[1]), largest(m[2])});
}

constexpr auto k_step = [](Rotation& r, const Vec3& I, const auto& torque, Real t,
                           Real dt) { splitting(r, I, torque, t, dt); };

}  // namespace

TEST_CASE("a force at a point is that force and the torque r x F") {
  RigidBody body = brick();
  add_force_at_point(body, {1, 2, 3}, {2, 0, 7});
  add_force(body, {0, 0, 1});
  add_torque(body, {0, 5, 0});

  // r = (1, 2, 4): small whole numbers, exact
  CHECK(body.force == Vec3(1, 2, 4));
  CHECK(body.torque == Vec3(2 * 3 - 4 * 2, 4 * 1 - 1 * 3 + 5, 1 * 2 - 2 * 1));

  // Along a line through the centre of mass there is no torque; a couple has no force
  RigidBody other = brick();
  add_force_at_point(other, {2, 4, 8}, other.position + Vec3(1, 2, 4));
  CHECK(other.torque == Vec3(0));
  add_force_at_point(other, {-2, -4, -8}, other.position + Vec3(0, 1, 0));
  CHECK(other.force == Vec3(0));
  CHECK(other.torque == glm::cross(Vec3(0, 1, 0), Vec3(-2, -4, -8)));
}

TEST_CASE("points of a body move with it") {
  // The velocity at a point is how fast the point goes: the difference over a short
  // time
  const RigidBody body = brick();
  const Vec3 r(Real(0.3), -1, 2);
  const Real h = std::cbrt(Real(k_u));
  const auto at = [&](Real t) {
    RigidBody moved = body;
    moved.position += t * body.velocity;
    moved.orientation = rotation_by(t * body.angular_velocity) * body.orientation;
    return world_point(moved, r);
  };

  // Rounding u of numbers up to 5 over 2 h, curvature h² |omega|³ |r| / 6
  const Vec3 measured = (at(h) - at(-h)) / (2 * h);
  const double bound = 4 * k_u * 5 / h + double(h) * h * 12 * 2.3 / 6;
  CHECK(largest(measured - velocity_at(body, at(0))) <= bound);
}

TEST_CASE("the world's inverse inertia is R I⁻¹ Rᵀ") {
  const RigidBody body = brick();
  const Mat3 W = world_inverse_inertia(body);

  // It turns into the body, scales there, and turns back. 16 roundings of 2 at most
  const double bound = 16 * k_u * 2;
  for (const Vec3& v : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 2, -3)}) {
    const Vec3 local = body.inverse_inertia * in_body(body.orientation, v);
    CHECK(largest(W * v - body.orientation * local) <= bound * 4);
  }
  CHECK(largest(W - glm::transpose(W)) <= bound);

  // Nothing is stale: it follows the orientation at once
  RigidBody moved = body;
  moved.orientation = Quat(1, 0, 0, 0);
  CHECK(world_inverse_inertia(moved) == Mat3(Real(0.5), 0, 0, 0, 2, 0, 0, 0, 1));
}

TEST_CASE(
    "torque times tensor is tensor times torque because the tensor is symmetric") {
  // The thesis multiplies from the wrong side, and gets away with it
  const RigidBody body = brick();
  const Vec3 torque(1, 2, -3);
  const Mat3 W = world_inverse_inertia(body);
  CHECK(largest(torque * W - W * torque) <= 16 * k_u * 2 * 6);

  // Without the last turn, R I⁻¹, it would not
  const Mat3 R = matrix_of(body.orientation);
  const Mat3 half = R * Mat3(Real(0.5), 0, 0, 0, 2, 0, 0, 0, 1);
  CHECK(largest(torque * half - half * torque) > 0.1);
}

TEST_CASE("a centre of mass falls on semi-implicit Euler's parabola") {
  RigidBody body = brick();
  const RigidBody start = body;
  constexpr double g = -9.81, dt = 1.0 / 60;
  constexpr int n = 120;
  for (int i = 0; i < n; ++i) {
    add_force(body, {0, Real(2 * g), 0});
    integrate(body, k_step, Real(dt));
  }

  // 6 roundings a step of v (up to 16 m/s), carried on for 2 s, and of x (up to 20 m)
  const double t = n * dt;
  const double bound = n * 6 * k_u * (16 * t + 20);
  CHECK(body.position.y
        == Approx(start.position.y + start.velocity.y * t + g * t * (t + dt) / 2)
               .margin(bound));
  CHECK(body.position.x
        == Approx(start.position.x + start.velocity.x * t).margin(bound));

  // Weight has no torque, so L stays: 16 roundings a turn, five turns a step
  const auto L = [](const RigidBody& b) {
    return momentum_of(rotation_of(b), Vec3(1) / b.inverse_inertia);
  };
  CHECK(glm::length(L(body) - L(start)) <= n * 5 * 16 * k_u * glm::length(L(start)));
}

TEST_CASE("force and torque act through one step") {
  RigidBody body = brick();
  add_force_at_point(body, {3, 0, 0}, {0, 5, 0});
  const Vec3 torque = body.torque;
  const RigidBody start = body;
  constexpr Real dt = Real(0.01);
  integrate(body, k_step, dt);
  CHECK(body.force == Vec3(0));
  CHECK(body.torque == Vec3(0));

  // L grows by torque dt: 5 turns, 16 roundings each, of up to 22 N m s
  const Vec3 I = Vec3(1) / start.inverse_inertia;
  const glm::dvec3 gained =
      momentum_of(rotation_of(body), I) - momentum_of(rotation_of(start), I);
  CHECK(glm::length(gained - glm::dvec3(torque) * double(dt)) <= 5 * 16 * k_u * 22);
}

TEST_CASE("a static body never moves") {
  RigidBody wall{.position = {1, 2, 3}, .orientation = {Real(0.6), 0, Real(0.8), 0}};
  for (int i = 0; i < 1000; ++i) {
    add_force_at_point(wall, {1e6, -3, 2}, {0, 0, 9});
    integrate(wall, k_step, Real(1) / 60);
  }
  CHECK(wall.position == Vec3(1, 2, 3));
  CHECK(wall.velocity == Vec3(0));
  CHECK(wall.angular_velocity == Vec3(0));

  // Normalising may move a number of q by u, and no further
  const glm::dquat before(Real(0.6), 0, Real(0.8), 0);
  CHECK(exact::angle_between(before, glm::dquat(wall.orientation)) <= 8 * k_u);
}

TEST_CASE("a body without inverse inertia turns as it is told to") {
  RigidBody table{.angular_velocity = {0, 3, 0}};
  for (int i = 0; i < 60; ++i) integrate(table, k_step, Real(1) / 60);
  const glm::dquat expected = glm::angleAxis(3.0, glm::dvec3(0, 1, 0));

  // 60 steps of 16 roundings; dt rounds 3 rad
  CHECK(exact::angle_between(expected, glm::dquat(table.orientation))
        <= (60 * 16 + 3) * k_u);
  CHECK(table.angular_velocity == Vec3(0, 3, 0));
}

TEST_CASE("damping leaves its share after a second") {
  RigidBody body = brick();
  const RigidBody start = body;
  for (int i = 0; i < 60; ++i) damp(body, Real(0.5), Real(0.25), Real(1) / 60);

  // A power and a product a step: 4 roundings
  CHECK(largest(body.velocity - Real(0.5) * start.velocity) <= 60 * 4 * k_u * 2);
  CHECK(largest(body.angular_velocity - Real(0.25) * start.angular_velocity)
        <= 60 * 4 * k_u * 0.5);
}

TEST_CASE("rotation_of and set_rotation are each other's inverse") {
  RigidBody body = brick();
  const Vec3 before = body.angular_velocity;
  set_rotation(body, rotation_of(body));
  CHECK(body.orientation == brick().orientation);
  CHECK(largest(body.angular_velocity - before) <= 16 * k_u * 2.3);
}

TEST_CASE("the way to the world and back does not add energy step by step") {
  RigidBody body{.angular_velocity = {1, 2, 3},
                 .inverse_mass = 1,
                 .inverse_inertia = Vec3(1) / asymmetric()};
  const auto energy = [&] { return energy_of(rotation_of(body), asymmetric()); };
  const double before = energy();
  constexpr int n = 6000;
  for (int i = 0; i < n; ++i) integrate(body, k_step, Real(1) / 60);

  // What splitting itself is off by, at this speed; and, as a walk of 2 n steps at
  // random, four roundings of a vector each way: energy is a square, four deviations
  const double walk = 4 * 2 * 4 * k_u * std::sqrt(2.0 * n);
  CHECK(std::abs(energy() / before - 1) <= 5e-5 + walk);

  // Where every way stretched the vector by u, the energy would have grown by 4 n u
  if (k_single) CHECK(walk + 5e-5 < 4 * n * k_u / 2);
}
