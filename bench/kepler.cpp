// One planet: our methods, as schemes on a whole state and on a particle alone.
#include "bench/kepler.hpp"

#include <string>

#include "common/physics/runge_kutta.hpp"
#include "common/physics/schemes.hpp"
#include "common/physics/swarm.hpp"
#include "common/physics/yoshida.hpp"

namespace timestep::inline TIMESTEP_PRECISION::bench {
namespace {

constexpr auto k_gravity = [](auto x, auto, Real, auto a) {
  put(a, 0, gravity_towards_origin(1, at(x, 0)));
};

State planet() {
  return {.x = {k_pericentre, 0, 0}, .v = {0, k_speed, 0}, .a = {0, 0, 0}};
}

struct Whole {
  Integration planet;

  void step(double) { advance(planet); }
  Vec3 x() const { return at(read(planet).x, 0); }
  Vec3 v() const { return at(read(planet).v, 0); }
};

template <typename Step>
struct Alone {
  Step take_step;
  Particle planet;

  void step(double t) { take_step(planet, t); }
  Vec3 x() const { return at(planet.x, 0); }
  Vec3 v() const { return at(planet.v, 0); }
};

void add_whole(const Scheme& scheme) {
  const auto make = [scheme] {
    return Whole{begin(scheme, k_gravity, planet(), k_dt)};
  };
  benchmark::RegisterBenchmark(
      ("kepler/" + std::string(scheme.name) + "/whole").c_str(),
      [make](benchmark::State& run) { measure_orbit(run, make); });
}

template <typename Step>
void add_alone(const std::string& method, Step step) {
  const auto make = [step] {
    Alone<Step> all{step, {.x = {k_pericentre, 0, 0}, .v = {0, k_speed, 0}, .a = {}}};
    evaluate(all.planet, k_gravity, 0);
    return all;
  };
  benchmark::RegisterBenchmark(
      ("kepler/" + method + "/alone").c_str(),
      [make](benchmark::State& run) { measure_orbit(run, make); });
}

}  // namespace

void add_kepler() {
  for (const Scheme& scheme : schemes()) add_whole(scheme);
  add_alone("semi_implicit_euler",
            [](Particle& p, Real t) { kick_drift(p, k_gravity, t, k_dt); });
  add_alone("semi_implicit_euler_drift_kick", [](Particle& p, Real t) {
    semi_implicit_euler_drift_kick(p, k_gravity, t, k_dt);
  });
  add_alone("velocity_verlet",
            [](Particle& p, Real t) { velocity_verlet(p, k_gravity, t, k_dt); });
  add_alone("position_verlet",
            [](Particle& p, Real t) { position_verlet(p, k_gravity, t, k_dt); });
  add_alone("yoshida4_kdk",
            [](Particle& p, Real t) { yoshida4_kdk(p, k_gravity, t, k_dt); });
  add_alone("yoshida4_dkd",
            [](Particle& p, Real t) { yoshida4_dkd(p, k_gravity, t, k_dt); });
  add_alone("midpoint", [](Particle& p, Real t) {
    std::array<Particle, 1> stages;
    midpoint(p, stages, k_gravity, t, k_dt);
  });
  add_alone("heun", [](Particle& p, Real t) {
    std::array<Particle, 1> stages;
    heun(p, stages, k_gravity, t, k_dt);
  });
  add_alone("rk4", [](Particle& p, Real t) {
    std::array<Particle, 3> stages;
    rk4(p, stages, k_gravity, t, k_dt);
  });
  add_alone("dopri5", [](Particle& p, Real t) {
    std::array<Particle, 7> stages;
    dopri5(p, stages, k_gravity, t, k_dt);
  });
}

}  // namespace timestep::inline TIMESTEP_PRECISION::bench
