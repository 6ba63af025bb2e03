// Shares of whole numbers, walls, and the centre of mass of random pairs.
#include "chapters/05-penetration/exercises/5_1_who_moves.hpp"

#include <cmath>
#include <limits>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

TEST_CASE("of 1 kg and 3 kg, the lighter moves three times as far") {
  const Shares shares = part(1, 1.0 / 3, 0.4, {0, 1, 0});
  expect("what 1 kg is moved by [m]", shares.a, {0, -0.3, 0}, 4 * k_u);
  expect("what 3 kg is moved by [m]", shares.b, {0, 0.1, 0}, 4 * k_u);
}

TEST_CASE("a wall stays, and what is in it goes all the way") {
  const Shares floor = part(0, 1.0 / 7, 0.1, {0, 1, 0});
  expect("what the floor is moved by [m]", floor.a, {0, 0, 0}, 0);
  expect("what 7 kg on the floor are moved by [m]", floor.b, {0, 0.1, 0}, 2 * k_u);
  const Shares ceiling = part(1.0 / 7, 0, 0.1, {0, 1, 0});
  expect("what 7 kg below a ceiling are moved by [m]", ceiling.a, {0, -0.1, 0},
         2 * k_u);
}

TEST_CASE("two walls stay as they are") {
  const Shares shares = part(0, 0, 0.1, {1, 0, 0});
  expect("what a wall in a wall is moved by [m]", shares.a, {0, 0, 0}, 0);
  expect("what the other is moved by [m]", shares.b, {0, 0, 0}, 0);
}

TEST_CASE("the centre of mass stays, and the depth is gone") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Real mass_a = random.log_between(1e-12, 1e12);
    const Real mass_b = random.log_between(1e-12, 1e12);
    const Real depth = random.log_between(1e-6, 1e3);
    const Shares shares = part(1 / mass_a, 1 / mass_b, depth, {0, 0, 1});
    const std::string who = fmt::format("{:.3g} kg and {:.3g} kg", mass_a, mass_b);
    expect("how far apart [m] go " + who, shares.b.z - shares.a.z, depth,
           8 * k_u * depth);

    // In units of what the heavier one's share is rounded to
    const Real reduced = mass_a * mass_b / (mass_a + mass_b);
    expect("mass times way [kg m] of " + who + ", together",
           mass_a * shares.a.z + mass_b * shares.b.z, 0, 16 * k_u * reduced * depth);
  }
}
