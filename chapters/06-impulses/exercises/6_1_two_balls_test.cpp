// Collisions with well-known ends, then what holds of all of them.
#include "chapters/06-impulses/exercises/6_1_two_balls.hpp"

#include <string>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

constexpr Real k_rounding = 1e-13;

void expect_after(const char* what, const Ball& a, const Ball& b, Real e,
                  const Vec3& right_a, const Vec3& right_b) {
  const auto [of_a, of_b] = after_collision(a, b, e);
  expect(std::string("velocity [m/s] of a, ") + what, of_a, right_a, k_rounding);
  expect(std::string("velocity [m/s] of b, ") + what, of_b, right_b, k_rounding);
}

}  // namespace

TEST_CASE("equal balls, head on") {
  const Ball a{1, {0, 0, 0}, {3, 0, 0}}, b{1, {0.5, 0, 0}, {-1, 0, 0}};
  expect_after("e = 1", a, b, 1, {-1, 0, 0}, {3, 0, 0});
  expect_after("e = 0", a, b, 0, {1, 0, 0}, {1, 0, 0});
  expect_after("e = 1/2", a, b, 0.5, {0, 0, 0}, {2, 0, 0});
}

TEST_CASE("masses matter") {
  const Ball heavy{0.25, {0, 0, 0}, {1, 0, 0}}, light{1, {1, 0, 0}, {0, 0, 0}};
  expect_after("4 kg on 1 kg", heavy, light, 1, {0.6, 0, 0}, {1.6, 0, 0});
  const Ball wall{0, {1, 0, 0}, {0, 0, 0}};
  expect_after("against a wall", heavy, wall, 0.5, {-0.5, 0, 0}, {0, 0, 0});
}

TEST_CASE("what parts, or what nothing moves, is left alone") {
  const Ball a{1, {0, 0, 0}, {-1, 2, 0}}, b{1, {1, 0, 0}, {1, 0, 5}};
  expect_after("parting", a, b, 1, a.velocity, b.velocity);
  const Ball train{0, {0, 0, 0}, {30, 0, 0}}, wall{0, {1, 0, 0}, {0, 0, 0}};
  expect_after("train and wall", train, wall, 1, train.velocity, wall.velocity);
}

TEST_CASE("any two balls") {
  Random random(61);
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ball a{random.log_between(1e-3, 1e3), random.in_cube(), random.in_cube()};
    const Ball b{random.log_between(1e-3, 1e3), random.in_cube(), random.in_cube()};
    const Real e = random.between(0, 1);
    const auto [of_a, of_b] = after_collision(a, b, e);
    const Vec3 n = glm::normalize(b.position - a.position);
    const Real before = glm::dot(n, b.velocity - a.velocity);
    const Real after = glm::dot(n, of_b - of_a);
    met += before < 0;

    // Rounding: sums of velocities below 4 m/s, and momenta of masses below 1000 kg
    expect("parting speed [m/s]", after, before < 0 ? -e * before : before, 1e-14);
    const Vec3 momentum = a.velocity / a.inverse_mass + b.velocity / b.inverse_mass;
    expect("momentum [kg m/s]", of_a / a.inverse_mass + of_b / b.inverse_mass, momentum,
           1e-11);
    expect("velocity of a across the normal [m/s]", of_a - glm::dot(of_a, n) * n,
           a.velocity - glm::dot(a.velocity, n) * n, 1e-14);
  }
  REQUIRE(met > 300);
}
