// A rod, whose end is four times as easy to move as its middle; a box that stands
// askew, beside the engine; and that no other motion would be less.
#include "chapters/05-penetration/exercises/5_2_up_or_level.hpp"

#include "common/physics/penetration.hpp"
#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// A rod of 2 m and 3 kg along x: m L² / 12 about its middle; about itself as good as
// nothing, so it gets what an equally thin one would have
RigidBody rod() {
  return {.inverse_mass = 1.0 / 3, .inverse_inertia = {1000, 1, 1}};
}

// m |moved|² + turned . I turned, which Gauss wants to be the least
Real motion(const RigidBody& body, const Motion& m) {
  const Vec3 turned = glm::conjugate(body.orientation) * m.turned;
  return glm::dot(m.moved, m.moved) / body.inverse_mass
         + glm::dot(turned, turned / body.inverse_inertia);
}

// Of the point, along the normal, to first order
Real way(const Motion& m, const Vec3& arm, const Vec3& normal) {
  return glm::dot(normal, m.moved + glm::cross(m.turned, arm));
}

}  // namespace

TEST_CASE("a rod's end is four times as easy to move as its middle") {
  expect("inverse mass [1/kg] in the middle of a rod of 3 kg",
         inverse_mass_at(rod(), {0, 0, 0}, {0, 1, 0}), 1.0 / 3, 4 * k_u);
  expect("inverse mass [1/kg] at its end", inverse_mass_at(rod(), {1, 0, 0}, {0, 1, 0}),
         4.0 / 3, 8 * k_u);
  expect("inverse mass [1/kg] at its end, along it",
         inverse_mass_at(rod(), {1, 0, 0}, {1, 0, 0}), 1.0 / 3, 4 * k_u);
}

TEST_CASE("push a rod's end up by 0.1 m, and its middle rises by a quarter of that") {
  const Motion m = push_by(rod(), {-1, 0, 0}, {0, 1, 0}, 0.1);
  expect("what the middle is moved by [m]", m.moved, {0, 0.025, 0}, 4 * k_u);
  expect("what the rod is turned by [rad]", m.turned, {0, 0, -0.075}, 4 * k_u);
}

TEST_CASE("a box that stands askew") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    RigidBody body{.inverse_mass = random.log_between(0.01, 100),
                   .inverse_inertia = {random.between(1, 2), random.between(1, 2),
                                       random.between(1, 2)}};
    body.orientation = random.turn();
    const Vec3 arm = random.direction(), normal = random.direction();
    const Real k = inverse_effective_mass(body, arm, normal);

    // Some thirty roundings in a sum of which no term is negative
    expect("inverse mass [1/kg]", inverse_mass_at(body, arm, normal), k, 64 * k_u * k);
    const Motion m = push_by(body, arm, normal, 0.1);
    expect("how far [m] the point goes", way(m, arm, normal), 0.1, 64 * k_u);

    // Any other motion that takes the point as far
    const Motion more{m.moved + 0.01 * random.direction(),
                      m.turned + 0.01 * random.direction()};
    const Real scale = 0.1 / way(more, arm, normal);
    const Motion other{scale * more.moved, scale * more.turned};
    if (motion(body, other) < motion(body, m) * (1 - 64 * k_u))
      FAIL(fmt::format(
          "there is a smaller motion that takes the point of box {} as far", i));
  }
}
