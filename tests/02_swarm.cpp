// Chapter 2: a particle that takes its steps alone ends with the bits that it has in a
// whole system, whatever the method, since both are compiled from the same lines.
#include <string_view>

#include "common/physics/runge_kutta.hpp"
#include "common/physics/schemes.hpp"
#include "common/physics/swarm.hpp"
#include "common/physics/systems.hpp"
#include "common/physics/yoshida.hpp"
#include "tests/catch.hpp"

using namespace timestep;

namespace {

constexpr Real k_dt = Real(0.01);

// Gravity towards the origin, and a push that grows with time
constexpr auto k_field = [](auto x, auto, Real t, auto a) {
  for (std::size_t i = 0; i < x.size() / 3; ++i)
    put(a, i, gravity_towards_origin(1, at(x, i)) + Vec3(0, 0, t / 10));
};

// On all kinds of orbits
State cloud(std::size_t n) {
  State state = particles(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Real s = Real(i) / Real(n);
    put(state.x, i, {1 + s, s * s, -s});
    put(state.v, i, {-s / 3, 1 - s / 2, Real(0.1) * s});
  }
  return state;
}

// `step` on each of 37 particles alone, beside the scheme of that name on all of them
template <std::size_t kept>
void check_same_bits(std::string_view scheme, const auto& step) {
  INFO(scheme);
  Integration whole = begin(*find_scheme(scheme), k_field, cloud(37), k_dt);
  Swarm<kept> swarm = swarm_of<kept>(whole.state);
  for (int i = 0; i < 200; ++i) {
    advance(whole);
    for_each(swarm, [&](Particle& p) { step(p, Real(i) * k_dt); });
  }

  const State alone = state_of(swarm);
  CHECK(alone.x == whole.state.x);
  CHECK(alone.v == whole.state.v);
  if (kept == 3) CHECK(alone.a == whole.state.a);
}

}  // namespace

TEST_CASE("A state becomes a swarm and a state again") {
  for (const std::size_t n : {0U, 1U, 7U, 8U, 9U, 16U, 37U}) {
    State state = cloud(n);
    k_field(std::span<const Real>(state.x), 0, 0, std::span<Real>(state.a));
    const State back = state_of(swarm_of<3>(state));
    CHECK(back.x == state.x);
    CHECK(back.v == state.v);
    CHECK(back.a == state.a);
    CHECK(state_of(swarm_of<2>(state)).v == state.v);
  }
}

TEST_CASE("What fills up the last pack is a particle, not a hole") {
  const Swarm<2> swarm = swarm_of<2>(cloud(k_lanes + 1));
  REQUIRE(swarm.packs.size() == 2);
  for (std::size_t lane = 1; lane < k_lanes; ++lane)
    CHECK(load(swarm.packs[1], lane).x == load(swarm.packs[1], 0).x);
}

TEST_CASE("Symplectic steps are the same alone and in a system, bit for bit") {
  check_same_bits<2>("semi_implicit_euler",
                     [](Particle& p, Real t) { kick_drift(p, k_field, t, k_dt); });
  check_same_bits<2>("leapfrog",
                     [](Particle& p, Real t) { kick_drift(p, k_field, t, k_dt); });
  check_same_bits<2>("semi_implicit_euler_drift_kick", [](Particle& p, Real t) {
    semi_implicit_euler_drift_kick(p, k_field, t, k_dt);
  });
  check_same_bits<3>("velocity_verlet",
                     [](Particle& p, Real t) { velocity_verlet(p, k_field, t, k_dt); });
  check_same_bits<2>("position_verlet",
                     [](Particle& p, Real t) { position_verlet(p, k_field, t, k_dt); });
  check_same_bits<3>("yoshida4_kdk",
                     [](Particle& p, Real t) { yoshida4_kdk(p, k_field, t, k_dt); });
  check_same_bits<2>("yoshida4_dkd",
                     [](Particle& p, Real t) { yoshida4_dkd(p, k_field, t, k_dt); });
}

TEST_CASE("Runge-Kutta steps are the same alone and in a system, bit for bit") {
  check_same_bits<2>("midpoint", [](Particle& p, Real t) {
    std::array<Particle, 1> stages;
    midpoint(p, stages, k_field, t, k_dt);
  });
  check_same_bits<2>("heun", [](Particle& p, Real t) {
    std::array<Particle, 1> stages;
    heun(p, stages, k_field, t, k_dt);
  });
  check_same_bits<2>("rk4", [](Particle& p, Real t) {
    std::array<Particle, 3> stages;
    rk4(p, stages, k_field, t, k_dt);
  });
  check_same_bits<3>("dopri5", [](Particle& p, Real t) {
    std::array<Particle, 7> stages;
    dopri5(p, stages, k_field, t, k_dt);
  });
}
