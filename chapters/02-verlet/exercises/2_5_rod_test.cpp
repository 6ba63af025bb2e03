// Whirling rods without gravity, whose next angle has a closed form with (2.26), and is
// the last one if the rod does not brake; a dumbbell in flight; and the exact pendulum.
#include "chapters/02-verlet/exercises/2_5_rod.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/physics/exact_pendulum.hpp"
#include "common/physics/particle.hpp"
#include "common/physics/verlet.hpp"
#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
constexpr Real k_length = 1.25;

// Two particles on a rod, in the plane z = 0, and where they were a step ago
struct Rod {
  std::array<Real, 2> inverse_mass;
  State now = particles(2), last = particles(2);
  Vec3 g{0};
  Real dt = 1;

  // Lets particle i have been in the first place, and now be in the second
  void place(std::size_t i, const Vec3& before, const Vec3& here) {
    put(last.x, i, before);
    put(now.x, i, here);
  }

  // A step of (2.2); the rod then is at its length no more
  void fly() {
    const auto fall = [this](auto, auto, Real, auto a) {
      for (const std::size_t i : {0U, 1U}) put(a, i, inverse_mass[i] > 0 ? g : Vec3(0));
    };
    stormer_verlet(now, {&last, 1}, fall, 0, dt);
  }

  void step() {
    fly();
    hold({0, 1, k_length}, inverse_mass, last.x, now.x);
  }

  Vec3 apart(const State& state) const { return at(state.x, 1) - at(state.x, 0); }

  // By how much it has turned in the last step
  Real angle() const {
    const Vec3 from = apart(last), to = apart(now);
    return std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
  }
};

Vec3 on_circle(Real angle) {
  return k_length * Vec3(std::sin(angle), -std::cos(angle), 0);
}

// One end held at the origin; the other has turned by `angle` in the last step
Rod whirling(Real angle) {
  Rod rod{.inverse_mass = {0, 2}};
  rod.place(1, on_circle(0.5 - angle), on_circle(0.5));
  return rod;
}

// Masses of 2 kg and 1/2 kg that tumble, drift and fall
Rod dumbbell() {
  Rod rod{.inverse_mass = {0.5, 2}, .g = {0, -9.81, 0}, .dt = 0.01};
  const Vec3 drift{0.01, 0.02, 0};
  rod.place(0, -0.2 * on_circle(0), drift - 0.2 * on_circle(0.1));
  rod.place(1, 0.8 * on_circle(0), drift + 0.8 * on_circle(0.1));
  return rod;
}

// The largest error of the angle in a swing of three seconds from a start at 2.5 rad
Real pendulum_error(int steps) {
  const Real omega0 = 3;
  const auto exactly = [&](double t) { return exact::pendulum({2.5, 0}, omega0, t).x; };
  Rod rod{.inverse_mass = {0, 2}, .g = {0, -omega0 * omega0 * k_length, 0}};
  rod.dt = Real(3) / steps;
  rod.place(1, on_circle(exactly(-rod.dt)), on_circle(exactly(0)));
  Real most = 0;
  for (int i = 1; i <= steps; ++i) {
    rod.step();
    const Vec3 here = at(rod.now.x, 1), right = on_circle(exactly(i * rod.dt));
    most = std::max(most, glm::length(here - right) / k_length);
  }
  return most;
}

}  // namespace

TEST_CASE("how much a rod of (2.26) brakes") {
  for (const Real angle : {0.001, 0.1, 1.0, 2.0, 3.0}) {
    Rod rod = whirling(angle);
    rod.fly();
    const DistanceConstraint constraint{0, 1, k_length};
    satisfy({&constraint, 1}, rod.inverse_mass, 1, rod.now.x);

    // A dozen roundings; with an arccosine they count more, the smaller the angle is
    expect(fmt::format("the angle [rad] after one of {}", angle), next_angle(angle),
           rod.angle(), 16 * k_u / std::min(angle, 1.0));
  }
}

TEST_CASE("the rod has its length again, and its centre stays") {
  Rod rod = dumbbell();
  rod.fly();
  const State free = rod.now;
  hold({0, 1, k_length}, rod.inverse_mass, rod.last.x, rod.now.x);
  expect("length [m] of a dumbbell after a step", glm::length(rod.apart(rod.now)),
         k_length, 16 * k_u * k_length);
  const Vec3 heavy = at(rod.now.x, 0) - at(free.x, 0);
  const Vec3 light = at(rod.now.x, 1) - at(free.x, 1);
  for (const int k : {0, 1, 2})
    expect(fmt::format("{} [m] that the light end of a dumbbell moves", "xyz"[k]),
           light[k], -4 * heavy[k], 16 * k_u * k_length);
}

TEST_CASE("a rod that whirls keeps its rate and its length") {
  // A place rounds four times a step, to u of the length; from then on the rate is off
  // by that, and by the next steps' roundings too
  for (const Real angle : {0.01, 0.2, 0.5}) {
    Rod rod = whirling(angle);
    for (int i = 1; i <= 1000; ++i) {
      rod.step();
      expect(fmt::format("angle [rad] of step {} of a rod that whirls", i), rod.angle(),
             angle, i * 16 * k_u);
      expect(fmt::format("length [m] after step {} of a rod that whirls", i),
             glm::length(rod.apart(rod.now)), k_length, 16 * k_u * k_length);
    }
  }
}

TEST_CASE("a dumbbell in flight tumbles at its rate") {
  // As above, but its places are up to 20 m away
  Rod rod = dumbbell();
  for (int i = 1; i <= 200; ++i) {
    rod.step();
    expect(fmt::format("angle [rad] of step {} of a dumbbell", i), rod.angle(), 0.1,
           i * 16 * k_u * 20);
  }
}

TEST_CASE("as a pendulum, half the step leaves a quarter of the error") {
  // The next term of the series has dt⁴
  const Real coarse = pendulum_error(600);
  expect("order of the largest error of a pendulum on a rod",
         std::log2(coarse / pendulum_error(1200)), 2, 0.02);
}
