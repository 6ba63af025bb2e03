// Each of the four cases, then any two contacts, judged by what (6.14) asks for and
// compared with Lemke's method.
#include "chapters/06-impulses/exercises/6_5_two_contacts.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/physics/lcp.hpp"
#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

void expect_impulses(const char* what, const glm::dmat2& K, const glm::dvec2& v,
                     const glm::dvec2& right) {
  const glm::dvec2 z = two_contacts(K, v);
  expect(std::string("impulse [N s] of the first contact, ") + what, z.x, right.x,
         1e-14);
  expect(std::string("impulse [N s] of the second, ") + what, z.y, right.y, 1e-14);
}

}  // namespace

TEST_CASE("two contacts that do not know of each other") {
  const glm::dmat2 K(2, 0, 0, 4);
  expect_impulses("both close", K, {-1, -1}, {0.5, 0.25});
  expect_impulses("the first closes", K, {-1, 1}, {0.5, 0});
  expect_impulses("the second closes", K, {1, -1}, {0, 0.25});
  expect_impulses("none closes", K, {1, 0}, {0, 0});
}

TEST_CASE("a plank falls on two posts at its ends") {
  // 1 kg: each end weighs a quarter, and a push at one end pulls the other down
  const glm::dmat2 K(4, -2, -2, 4);
  expect_impulses("flat", K, {-1, -1}, {0.5, 0.5});
  expect_impulses("the first end first", K, {-1, 0}, {1.0 / 3, 1.0 / 6});
  expect_impulses("the second end rises enough", K, {-1, 0.6}, {0.25, 0});
}

TEST_CASE("a plank falls on two posts near its middle") {
  // A push at one lifts the other too
  const glm::dmat2 K(1.5, 0.75, 0.75, 1.5);
  expect_impulses("flat", K, {-1, -1}, {4.0 / 9, 4.0 / 9});
  expect_impulses("the second barely closes", K, {-1, -0.1}, {2.0 / 3, 0});
}

TEST_CASE("any two contacts") {
  Random random(65);
  std::array<int, 4> cases{};
  for (int i = 0; i < 4000; ++i) {
    // Inverse masses over six decades, the contacts up to nearly the same
    const double p = random.log_between(1e-3, 1e3), q = random.log_between(1e-3, 1e3);
    const double shared = 1 - random.log_between(1e-6, 1);
    const double between = (i % 2 == 0 ? 1 : -1) * shared * std::sqrt(p * q);
    const glm::dmat2 K(p, between, between, q);
    const glm::dvec2 v(random.in_cube());
    const glm::dvec2 z = two_contacts(K, v);
    ++cases[std::size_t((z.x > 0 ? 1 : 0) + (z.y > 0 ? 2 : 0))];

    // Rounding of K z, whose terms may be larger than what they add up to, and of z,
    // which is as uncertain as K is close to singular
    const std::string what = fmt::format("pair {}", i);
    const glm::dvec2 w = K * z + v;
    const glm::dvec2 terms(p * z.x + std::abs(between) * z.y + 1,
                           q * z.y + std::abs(between) * z.x + 1);
    const glm::dvec2 rounding = terms * (1e-14 * (1 + 1 / (1 - shared)));
    if (!(z.x >= 0 && z.y >= 0)) FAIL(what + ": an impulse pulls");
    if (w.x < -rounding.x || w.y < -rounding.y) FAIL(what + ": a contact still closes");
    if (z.x > 0)
      expect(what + ", speed [m/s] of the first, which pushes", w.x, 0, rounding.x);
    if (z.y > 0)
      expect(what + ", speed [m/s] of the second, which pushes", w.y, 0, rounding.y);

    // The same as the engine's, up to the condition of K, where that is moderate
    if (shared > 0.999) continue;
    const std::vector<double> lemkes =
        lemke({{p, between, between, q}, {v.x, v.y}}, 100);
    REQUIRE(lemkes.size() == 2);
    expect(what + ", impulse [N s] of the first", z.x, lemkes[0], 1e-7 * (1 + z.x));
    expect(what + ", impulse [N s] of the second", z.y, lemkes[1], 1e-7 * (1 + z.y));
  }
  for (const int count : cases) REQUIRE(count > 100);
}
