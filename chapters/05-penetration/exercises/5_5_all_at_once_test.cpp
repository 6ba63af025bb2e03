// Columns whose pushes can be found by hand, and long ones, where each contact is asked
// whether its depth is gone.
#include "chapters/05-penetration/exercises/5_5_all_at_once.hpp"

#include <chrono>

#include "tests/exercise.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

// How far contact i parts [m] under these pushes
Real parted(const std::vector<Real>& inverse_masses, const std::vector<Real>& push,
            std::size_t i) {
  const auto rise = [&](std::size_t ball) {
    const Real above = ball + 1 < push.size() ? push[ball + 1] : 0;
    return inverse_masses[ball] * (push[ball] - above);
  };
  return rise(i) - (i == 0 ? 0 : rise(i - 1));
}

void expect_parted(const std::vector<Real>& inverse_masses,
                   const std::vector<Real>& depths) {
  const std::size_t n = depths.size();
  const std::vector<Real> push = pushes(inverse_masses, depths);
  if (push.size() != n) FAIL(fmt::format("{} pushes for {} contacts", push.size(), n));
  for (std::size_t i = 0; i < n; ++i) {
    // The check subtracts pushes that n sums have rounded, and rises of neighbours
    const Real below = i == 0 ? 0 : inverse_masses[i - 1];
    const Real largest =
        push[i] * (inverse_masses[i] + below) + (i == 0 ? 0 : push[i - 1] * below);
    expect(fmt::format("how far contact {} of {} parts [m]", i, n),
           parted(inverse_masses, push, i), depths[i], 16 * k_u * largest);
  }
}

}  // namespace

TEST_CASE("one ball in the floor") {
  const std::vector<Real> w{0.5}, depth{0.1};
  expect("push [kg m] under 2 kg, 0.1 m deep", pushes(w, depth).at(0), 0.2, 4 * k_u);
}

TEST_CASE("two balls: the lower contact lifts both") {
  // The upper ball has to rise by 0.3 m, the lower one by 0.1 m
  const std::vector<Real> w{1, 0.5}, depths{0.1, 0.2};
  const std::vector<Real> push = pushes(w, depths);
  REQUIRE(push.size() == 2);
  expect("push [kg m] between 1 kg and 2 kg", push[1], 0.6, 4 * k_u);
  expect("push [kg m] of the floor", push[0], 0.7, 4 * k_u);
}

TEST_CASE("ten balls of any mass") {
  Random random(11);
  for (int k = 0; k < 100; ++k) {
    std::vector<Real> w, depths;
    for (int i = 0; i < 10; ++i) {
      w.push_back(random.log_between(1e-3, 1e3));
      depths.push_back(random.between(0, 0.1));
    }
    expect_parted(w, depths);
  }
}

TEST_CASE("a thousand balls of 1 kg, 1 mm each, at once") {
  const std::vector<Real> w(1000, 1), depths(1000, 0.001);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Real> push = pushes(w, depths);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  REQUIRE(push.size() == 1000);

  // 1 + 2 + ... + 1000 kg mm, a thousand roundings
  expect("push [kg m] of the floor", push[0], 500.5, 1000 * k_u * 500.5);
  expect_parted(w, depths);
  if (took.count() > 1) FAIL(fmt::format("it took {:.1f} s", took.count()));
}
