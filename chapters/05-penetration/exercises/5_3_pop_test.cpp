// One box that can be checked by hand, and columns of balls beside the engine.
#include "chapters/05-penetration/exercises/5_3_pop.hpp"

#include <vector>

#include "common/physics/penetration.hpp"
#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// What the engine's Baumgarte makes of the column, after enough sweeps: contact by
// contact its error shrinks by cos²(pi / 2 n) a sweep, 1e-19 after 2,000 for 10 bodies
std::vector<RigidBody> engine(const Column& column) {
  std::vector<RigidBody> bodies(1);
  std::vector<PointContact> contacts;
  for (int i = 1; i <= column.bodies; ++i) {
    RigidBody body;
    body.position = {0, i, 0};
    body.inverse_mass = 1 / column.mass;
    body.inverse_inertia = Vec3(1);
    bodies.push_back(body);
    const auto index = std::uint32_t(i);
    contacts.push_back({.a = index - 1,
                        .b = index,
                        .collider_a = index - 1,
                        .collider_b = index,
                        .feature = 0,
                        .position = {0, i - 0.5, 0},
                        .normal = {0, 1, 0},
                        .depth = column.depth,
                        .friction = 0,
                        .restitution = 0});
  }
  PenetrationRoom room;
  baumgarte(bodies, contacts,
            {.iterations = 2000, .slop = column.slop, .beta = column.beta}, column.dt,
            room);
  return bodies;
}

}  // namespace

TEST_CASE("one box, 5 cm in the floor at 60 Hz") {
  const Column column{1, 2, 0.05, 0.01, 0.2, 1.0 / 60};
  expect("speed [m/s]", speed_of(column, 1), 0.48, 8 * k_u);
  expect("energy [J] of 2 kg", energy_put_in(column), 0.2304, 8 * k_u);
  expect("rise [m]", rise(column, 9.81), 0.48 * 0.48 / 19.62, 8 * k_u);
}

TEST_CASE("what is no deeper than the slop gets no speed") {
  const Column column{3, 2, 0.005, 0.01, 0.2, 1.0 / 60};
  expect("speed [m/s] of the top", speed_of(column, 3), 0, 0);
  expect("energy [J]", energy_put_in(column), 0, 0);
}

TEST_CASE("columns fly apart as the engine's do") {
  for (const int n : {2, 5, 10}) {
    const Column column{n, 3, 0.1, 0.001, 0.2, 1.0 / 60};
    const std::vector<RigidBody> bodies = engine(column);
    Real energy = 0;
    for (int i = 1; i <= n; ++i) {
      const Real v = bodies[std::size_t(i)].velocity.y;
      energy += column.mass * v * v / 2;
      expect(fmt::format("speed [m/s] of body {} of {}", i, n), speed_of(column, i), v,
             1e-12 * v);
    }
    expect(fmt::format("energy [J] of {} bodies", n), energy_put_in(column), energy,
           1e-12 * energy);
    const Real top = bodies.back().velocity.y;
    expect(fmt::format("rise [m] of the top of {}", n), rise(column, 10),
           top * top / 20, 1e-12 * top * top);
  }
}
