// A rod, whose sweet spot is in every textbook, then bats of any shape, which the
// engine hits where you say.
#include "chapters/06-impulses/exercises/6_2_sweet_spot.hpp"

#include "common/physics/impulse.hpp"
#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// A bat of m kg whose principal moments [kg m²] are I
RigidBody bat_of(Real m, const Vec3& I) {
  RigidBody bat;
  bat.inverse_mass = 1 / m;
  bat.inverse_inertia = Vec3(1) / I;
  return bat;
}

}  // namespace

TEST_CASE("a rod, held at its end") {
  // m L² / 12 about its middle: two thirds of the way from the hand to the other end
  const Real L = 0.9, I = 1.2 * L * L / 12;
  const RigidBody rod = bat_of(1.2, {1e-4, I, I});
  expect("sweet spot [m]", sweet_spot(rod, -L / 2, {0, 1, 0}), L / 6, 1e-15);
  expect("sweet spot [m] of a blow from above", sweet_spot(rod, -L / 2, {0, 0, 1}),
         L / 6, 1e-15);
}

TEST_CASE("a flat bat has two, one for each way to hit it") {
  const RigidBody bat = bat_of(2, {0.01, 0.1, 0.4});
  expect("sweet spot [m] along y", sweet_spot(bat, -0.5, {0, 1, 0}), 0.4, 1e-15);
  expect("sweet spot [m] along z", sweet_spot(bat, -0.5, {0, 0, 1}), 0.1, 1e-15);
}

TEST_CASE("any bat, held anyhow, hit from any side") {
  Random random(62);
  for (int i = 0; i < 200; ++i) {
    // Moments that some body has, of a metre in size
    const Vec3 s = random.sizes(0.05, 1);
    const Vec3 I(s.y * s.y + s.z * s.z, s.z * s.z + s.x * s.x, s.x * s.x + s.y * s.y);
    RigidBody bat = bat_of(random.log_between(0.1, 10), I);
    bat.orientation = random.turn();
    bat.position = random.in_cube();
    const Vec3 along = turned_by(bat.orientation, Vec3(1, 0, 0));
    const Vec3 d = glm::normalize(glm::cross(along, random.direction()));
    const Real grip = -random.between(0.1, 1);

    const Real x = sweet_spot(bat, grip, d);
    RigidBody nothing;
    apply_impulse(nothing, bat, bat.position + x * along, d);
    const Vec3 hand = velocity_at(bat, bat.position + grip * along);
    const Real scale = 10 + std::abs(x * grip) * 1e3;
    expect("velocity [m/s] of the hand along the blow", glm::dot(hand, d), 0,
           1e-14 * scale);
  }
}
