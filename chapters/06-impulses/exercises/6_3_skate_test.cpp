// Where the answer is known, then what has to hold at the closest point of an ellipse.
#include "chapters/06-impulses/exercises/6_3_skate.hpp"

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

void expect_impulse(const char* what, const Skate& skate, const glm::dvec2& slip,
                    const glm::dvec2& right) {
  const glm::dvec2 J = friction_impulse(skate, slip);
  expect(what, glm::dvec3(J, 0), glm::dvec3(right, 0),
         1e-14 * (1 + glm::length(right)));
}

}  // namespace

TEST_CASE("what friction can hold, it holds") {
  const Skate skate{{0.01, 0.5}, 600, 70};
  expect_impulse("impulse [N s]", skate, {0.05, 0}, {-3.5, 0});
  expect_impulse("impulse [N s]", skate, {0.05, -2}, {-3.5, 140});
  expect_impulse("impulse [N s]", skate, {0, 0}, {0, 0});
}

TEST_CASE("along the blade and across it, as much as there is") {
  const Skate skate{{0.01, 0.5}, 600, 70};
  expect_impulse("impulse [N s] along", skate, {8, 0}, {-6, 0});
  expect_impulse("impulse [N s] across", skate, {0, -8}, {0, 300});
}

TEST_CASE("in the air there is none") {
  expect_impulse("impulse [N s]", {{0.01, 0.5}, 0, 70}, {8, 3}, {0, 0});
}

TEST_CASE("with the same friction everywhere it is Coulomb's circle") {
  Random random(63);
  for (int i = 0; i < 200; ++i) {
    const Vec3 v = 5.0 * random.in_cube();
    const Skate skate{glm::dvec2(random.log_between(0.01, 1)), 100, 50};
    const Vec3 right =
        in_cone(-50.0 * Vec3(v.x, v.y, 0), skate.friction.x, skate.normal_impulse);
    expect("impulse [N s]", glm::dvec3(friction_impulse(skate, {v.x, v.y}), 0), right,
           1e-12);
  }
}

TEST_CASE("the closest point of the ellipse") {
  Random random(631);
  int slips = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 slip(random.in_cube(10));
    const Skate skate{glm::dvec2(random.sizes(0.01, 1)), random.log_between(1, 1000),
                      random.log_between(1, 100)};
    const glm::dvec2 a = skate.friction * skate.normal_impulse;
    const glm::dvec2 J = friction_impulse(skate, slip);
    const double within = glm::length(J / a);
    if (glm::length(skate.effective_mass * slip / a) <= 1) continue;
    ++slips;
    expect("J's place in the ellipse, 1 on its edge,", within, 1, 1e-12);

    // What is left slips against the ellipse's normal: no turn between the two
    const glm::dvec2 left = slip + J / skate.effective_mass, normal = J / (a * a);
    const double sizes = glm::length(left) * glm::length(normal);
    expect("cosine of what is left and the ellipse's normal",
           glm::dot(left, normal) / sizes, -1, 1e-9);
  }
  REQUIRE(slips > 500);
}

TEST_CASE("a push at an angle ends along the blade") {
  const Skate skate{{0.01, 0.5}, 70 * 9.81 / 60, 70};
  glm::dvec2 velocity(4, 2);
  for (int step = 0; step < 120; ++step)
    velocity += friction_impulse(skate, velocity) / skate.effective_mass;
  expect("velocity [m/s] across after two seconds", velocity.y, 0, 1e-12);

  // Along the blade no step takes more than a hundredth of g
  const double least = 4 - 0.01 * 9.81 * 2;
  if (velocity.x > 4 || velocity.x < least)
    FAIL(fmt::format("{:.3g} m/s along the blade, between {:.3g} and 4 is right",
                     velocity.x, least));
}
