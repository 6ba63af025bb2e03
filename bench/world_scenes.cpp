#include "bench/world_scenes.hpp"

#include <cmath>
#include <cstdint>

namespace timestep::world_bench {
namespace {

using glm::dvec3;

// From -1 to 1, the same numbers everywhere
struct Random {
  std::uint32_t state = 1;
  double operator()() {
    state = state * 1664525U + 1013904223U;
    return double(state >> 8) * 0x1p-23 - 1;
  }
  dvec3 vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
};

Body box(double mass, const dvec3& half_extents, const dvec3& position) {
  return {.solid = {.half_extents = half_extents}, .mass = mass, .position = position};
}

Body ball(double mass, double radius, const dvec3& position) {
  return {.solid = {.radius = radius}, .mass = mass, .position = position};
}

Body unit_box(const dvec3& position) {
  return box(1, dvec3(0.5), position);
}

// A held box whose top is the plane y = 0
Body floor() {
  return box(0, dvec3(200, 1, 200), dvec3(0, -1, 0));
}

Scene with_surfaces(Scene scene, double friction, double restitution) {
  for (Body& body : scene.bodies) {
    body.friction = friction;
    body.restitution = restitution;
  }
  return scene;
}

}  // namespace

Scene column() {
  Scene scene{{floor()}};
  for (int i = 0; i < 10; ++i) scene.bodies.push_back(unit_box({0, i + 0.5, 0}));
  return scene;
}

Scene pyramid() {
  constexpr int k_base = 20;
  constexpr double k_pitch = 1.05;
  Scene scene{{floor()}};
  for (int row = 0; row < k_base; ++row)
    for (int i = 0; i < k_base - row; ++i) {
      const double x = k_pitch * (i - (k_base - row - 1) / 2.0);
      scene.bodies.push_back(unit_box({x, row + 0.5, 0}));
    }
  return scene;
}

// No two overlap, however they are turned: 1.8 m is more than a diagonal
Scene pile() {
  constexpr double k_pitch = 1.8;
  Scene scene{{floor()}};
  Random random;
  for (int layer = 0; layer < 10; ++layer) {
    const dvec3 shift(random() / 2, 0, random() / 2);
    for (int i = 0; i < 100; ++i) {
      const dvec3 place =
          dvec3(glm::ivec3(i % 10, layer, i / 10)) - dvec3(4.5, -0.5, 4.5);
      Body body = unit_box(k_pitch * place + shift);
      body.orientation = glm::normalize(glm::dquat(1, random.vector()));
      scene.bodies.push_back(body);
    }
  }
  return scene;
}

Scene bouncing_ball() {
  constexpr double k_radius = 0.25;
  return with_surfaces({{floor(), ball(1, k_radius, {0, 1 + k_radius, 0})}}, 0, 1);
}

Scene sliding_block() {
  Body block = box(1, {0.5, 0.25, 0.5}, {0, 0.25, 0});
  block.velocity.x = k_block_speed;
  return with_surfaces({{floor(), block}}, k_block_friction, 0);
}

Scene elastic_gas() {
  Scene scene{.bodies = {}, .gravity = dvec3(0)};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-2.0, 2.0}) {
      dvec3 position(0), half(3);
      position[axis] = side;
      half[axis] = 1;
      scene.bodies.push_back(box(0, half, position));
    }
  Random random;
  for (int i = 0; i < 64; ++i) {
    const dvec3 place = dvec3(glm::ivec3(i % 4, i / 4 % 4, i / 16)) - 1.5;
    Body body = ball(1, 0.1, 0.5 * place + 0.1 * random.vector());
    body.velocity = 3.0 * random.vector();
    scene.bodies.push_back(body);
  }
  return with_surfaces(scene, 0, 1);
}

// Surfaces whose geometric means are 0.4 between plate and floor, 0.8 between plate
// and balls
Scene rolling(const dvec3& along) {
  Body ground = floor(), plate = box(k_plate_mass, {10, 0.5, 10}, {0, 0.5, 0});
  plate.force = k_pull * along;
  plate.friction = 0.8;
  ground.friction = k_floor_friction * k_floor_friction / plate.friction;
  Scene scene{{ground, plate}};
  for (int i = 0; i < k_balls_on_plate; ++i) {
    const dvec3 place(2 * (i % 5) - 4, 1.5, 2 * (i / 5) - 4);
    scene.bodies.push_back(ball(1, 0.5, place));
    scene.bodies.back().friction = plate.friction;
  }
  return scene;
}

Scene bouncing() {
  Scene scene{{floor()}};
  for (int i = 0; i < 49; ++i)
    scene.bodies.push_back(ball(10, 0.1, {i % 7 - 3, 5, i / 7 - 3}));
  return with_surfaces(scene, 0, 1);
}

Scene six_cubed(double base, double restitution) {
  constexpr double k_pitch = 0.21;
  Scene scene{{floor()}};
  Random random;
  for (int i = 0; i < 216; ++i) {
    const dvec3 place =
        dvec3(glm::ivec3(i % 6, i / 36, i / 6 % 6)) - dvec3(2.5, 0, 2.5);
    const dvec3 position =
        dvec3(0, base, 0) + k_pitch * place + 0.001 * random.vector();
    scene.bodies.push_back(ball(10, 0.1, position));
  }
  return with_surfaces(scene, 0, restitution);
}

}  // namespace timestep::world_bench
