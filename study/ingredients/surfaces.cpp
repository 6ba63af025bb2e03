#include <cmath>

#include "common/physics/exact_bounce.hpp"
#include "common/physics/exact_cue_ball.hpp"
#include "common/physics/exact_sliding.hpp"
#include "study/ingredients/contacts.hpp"
#include "study/ingredients/worlds.hpp"

namespace timestep::inline TIMESTEP_PRECISION::ingredients {
namespace {

using study::Comparison;
using study::Model;

const glm::dvec3 k_block(0.6, 0.15, 0.6);  // [m] flat: it slides before it tips

// --- a block on a slope: level ground under gravity that leans along x ---------------

struct Slope {
  double angle, speed;
  Collider surface;
  double exact_friction;
};

Model on_slope(const std::string& name, const Slope& slope, int substeps = 4) {
  World world = ground(slope.surface);
  const Real g = Real(k_gravity), angle = Real(slope.angle);
  world.settings.gravity = g * Vec3(std::sin(angle), -std::cos(angle), 0);
  world.settings.substeps = substeps;
  const std::size_t block =
      add_box(world, 1, k_block, {0, k_block.y / 2, 0}, slope.surface);
  world.bodies[block].velocity.x = Real(slope.speed);
  const double mu = slope.exact_friction;
  const exact::Incline incline{slope.angle, mu, mu, k_gravity};
  const auto error = [=](const World& now, double t) {
    return std::abs(double(now.bodies[block].position.x)
                    - exact::on_incline(incline, slope.speed, t).x);
  };
  return {name, [=] { return moving(world, error); }};
}

// --- balls ---------------------------------------------------------------------------

constexpr double k_radius = 0.1;  // [m] of all balls

// Dropped from 1 m
Model bouncing(const std::string& name, const Collider& surface, double threshold) {
  World world = ground(surface);
  world.settings.restitution_threshold = Real(threshold);
  const std::size_t ball = add_ball(world, 1, k_radius, {0, 1 + k_radius, 0}, surface);
  const exact::BouncingBall exact{1, double(surface.restitution), k_gravity};
  const auto error = [=](const World& now, double t) {
    return std::abs(double(now.bodies[ball].position.y) - k_radius
                    - exact::bouncing_ball(exact, t).x);
  };
  return {name, [=] { return moving(world, error); }};
}

// Set off at 2 m/s without a spin: it slides, then it rolls
Model struck_level(const std::string& name, bool turns) {
  constexpr double k_speed = 2;
  const Collider cloth{.friction = Real(0.2)};
  World world = ground(cloth);
  const std::size_t ball = add_ball(world, 1, k_radius, {0, k_radius, 0}, cloth);
  world.bodies[ball].velocity.x = Real(k_speed);
  if (!turns) world.bodies[ball].inverse_inertia = Vec3(0);
  const exact::Ball exact{1, k_radius, 0.4, 0.2, k_gravity};
  const auto error = [=](const World& now, double t) {
    const exact::BallMotion start{glm::dvec3(0), {k_speed, 0, 0}, glm::dvec3(0)};
    return std::abs(double(now.bodies[ball].position.x)
                    - exact::slide_then_roll(exact, start, t).x.x);
  };
  return {name, [=] { return moving(world, error); }};
}

// Rolling at 1 m/s, slowed down by m g rho / r with the inertia of a solid ball
Model rolling(const std::string& name, double rolling_friction) {
  constexpr double k_speed = 1, k_arm = 0.005;
  Collider grass{.friction = Real(0.5)};
  grass.rolling_friction = Real(rolling_friction * k_arm);
  World world = ground(grass);
  const std::size_t ball = add_ball(world, 1, k_radius, {0, k_radius, 0}, grass);
  world.bodies[ball].velocity.x = Real(k_speed);
  world.bodies[ball].angular_velocity.z = Real(-k_speed / k_radius);
  const double slowing = k_arm * k_gravity / (1.4 * k_radius);
  const auto error = [=](const World& now, double time) {
    const double t = std::min(time, k_speed / slowing);
    return std::abs(double(now.bodies[ball].position.x)
                    - (k_speed - slowing * t / 2) * t);
  };
  return {name, [=] { return moving(world, error); }};
}

// --- the rows ------------------------------------------------------------------------

Comparison place(const std::string& ingredient, const std::string& scene, bool matters,
                 const std::string& exact, int steps, const Model& with,
                 const Model& without) {
  return {.ingredient = ingredient,
          .scene = scene,
          .matters = matters,
          .metric = "place",
          .unit = "m",
          .exact = exact,
          .steps = steps,
          .with = with,
          .without = without};
}

Slope slope_of(double angle, double speed, double friction) {
  return {angle, speed, {.friction = Real(friction)}, friction};
}

Comparison friction_on_slope() {
  const Slope rough = slope_of(0.3, 0, 0.5);
  Slope smooth = rough;
  smooth.surface.friction = 0;
  return place("friction", "block at rest on a slope", true, "rest", 60,
               on_slope("mu = 0.5", rough), on_slope("mu = 0", smooth));
}

Comparison friction_of_bounce() {
  const Collider rough{.friction = Real(0.5), .restitution = Real(0.8)};
  Collider smooth = rough;
  smooth.friction = 0;
  return place("friction", "ball dropped straight down", false, "bounces", 60,
               bouncing("mu = 0.5", rough, 0), bouncing("mu = 0", smooth, 0));
}

Comparison rolling_friction_of_block() {
  const Slope slides = slope_of(0.5, 0, 0.4);
  Slope resists = slides;
  resists.surface.rolling_friction = Real(0.005);
  return place("rolling friction", "block that slides down a slope", false,
               "Coulomb's law", 60, on_slope("5 mm", resists), on_slope("0", slides));
}

}  // namespace

std::vector<Comparison> surface_comparisons() {
  const Collider lively{.friction = Real(0.5), .restitution = Real(0.8)};
  const Slope slides = slope_of(0.5, 0, 0.4);
  return {
      place("rotation", "ball struck level on a table", true, "sliding, then rolling",
            120, struck_level("rigid body", true), struck_level("point mass", false)),
      friction_on_slope(),
      friction_of_bounce(),
      place("rolling friction", "ball that rolls on grass", true,
            "even slowing down to rest", 240, rolling("5 mm", 1), rolling("0", 0)),
      rolling_friction_of_block(),
      place("restitution threshold", "first bounces of a ball", false, "bounces", 60,
            bouncing("0.5 m/s", lively, 0.5), bouncing("0", lively, 0)),
      place("sub-steps", "block that slides down a slope", false, "Coulomb's law", 60,
            on_slope("4", slides), on_slope("1", slides, 1))};
}

}  // namespace timestep::inline TIMESTEP_PRECISION::ingredients
