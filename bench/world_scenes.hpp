/// @file
/// Scenes of rigid bodies as every library gets them. SI units, y up.
#pragma once

#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep::world_bench {

/// A ball, or a box: what is not zero [m].
struct Solid {
  double radius = 0;
  glm::dvec3 half_extents{0};
};

/// A body at its start. The friction of a pair is the geometric mean of the surfaces',
/// its restitution the larger one.
struct Body {
  Solid solid;
  double mass = 0;  ///< [kg] 0: it is held
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
  glm::dvec3 velocity{0};
  glm::dvec3 force{0};  ///< [N] on the centre of mass, all the time
  double friction = 0.5;
  double restitution = 0;
};

struct Scene {
  std::vector<Body> bodies;
  glm::dvec3 gravity{0, -9.81, 0};
};

/// A body in the world frame.
struct State {
  glm::dvec3 position;
  glm::dquat orientation;  ///< of length one
  glm::dvec3 velocity, angular_velocity;
};

// Boxes of 1 m and 1 kg on a floor: ten on each other; a wall of rows from 20 to 1; a
// thousand that fall, turned and shifted at random, in layers of a hundred. The top
// body is the last one.
Scene column();
Scene pyramid();
Scene pile();

/// A ball without friction that is let go 1 m above the floor, e = 1.
Scene bouncing_ball();

/// A flat block that slides at k_block_speed on a floor, mu = k_block_friction.
inline constexpr double k_block_speed = 5, k_block_friction = 0.5;
Scene sliding_block();

/// 64 balls in a box of 2 m without gravity and friction, e = 1.
Scene elastic_gas();

// SimBenchmark's scenes. Source: D. Kang, J. Hwangbo, SimBenchmark, 2018.

/// A plate that is pulled along the floor with 25 balls on top: 150 N along a level
/// unit vector.
Scene rolling(const glm::dvec3& along);
inline constexpr double k_pull = 150, k_plate_mass = 10, k_floor_friction = 0.4;
inline constexpr int k_balls_on_plate = 25;

/// 49 balls fall from 5 m, e = 1, without friction.
Scene bouncing();

/// 216 balls in a cube, shifted at random by up to 1 mm, that fall from so high [m]
/// without friction.
Scene six_cubed(double base, double restitution);

}  // namespace timestep::world_bench
