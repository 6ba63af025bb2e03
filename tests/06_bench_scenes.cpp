// The scenes that other libraries are measured on, and the measures themselves.
#include <cmath>
#include <stdexcept>

#include "bench/simbench.hpp"
#include "tests/catch.hpp"

using namespace timestep::world_bench;

namespace {

constexpr double k_u = 0x1p-53;

std::vector<State> at_start(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies)
    states.push_back({body.position, body.orientation, body.velocity, glm::dvec3(0)});
  return states;
}

// A library in which nothing ever moves, but everything is shifted at once
Engine idle(const glm::dvec3& shift) {
  const auto make = [=](const Scene& scene, const Settings&) {
    std::vector<State> states = at_start(scene);
    for (State& state : states) state.position += shift;
    return Simulation{[] {}, [=] { return states; }};
  };
  return {.name = "idle", .make = make};
}

double error_of(const Engine& engine, const std::string& name) {
  for (const SimbenchScene& one : simbench_scenes(false))
    if (one.name == name)
      return mean_over_time(engine, one.scene, one.settings.back(), one.duration,
                            one.error)
          .mean;
  throw std::invalid_argument(name);
}

Scene pair_of(const Solid& a, const Solid& b, const glm::dvec3& place_of_b) {
  return {{{.solid = a, .mass = 1}, {.solid = b, .mass = 1, .position = place_of_b}}};
}

}  // namespace

// SimBenchmark publishes 3.145 for those in which nothing moves: 16/3 s² (a_box² +
// a_ball²). Asked 400 times, at the end of each 10 ms, the mean of t² is higher by the
// share 3 / 800; its a have four digits
TEST_CASE("what does not roll has the error that SimBenchmark publishes for it") {
  const double expected = 3.145 * (1 + 3.0 / 800);
  CHECK(std::abs(error_of(idle({}), "rolling") - expected) < 2e-3);
  CHECK(std::abs(error_of(idle({}), "rolling_diagonal") - expected) < 2e-3);
}

TEST_CASE("energy's error is that of all balls together") {
  const double fallen = 49 * 10 * 9.81 * 0.01;
  CHECK(error_of(idle({}), "bouncing") == 0);
  const double found = error_of(idle({0, -0.01, 0}), "bouncing");

  // Energies of 24 kJ, rounded some fifty times
  const double tolerance = 2 * fallen * 100 * k_u * 24e3;
  CHECK(std::abs(found - fallen * fallen) < tolerance);
  CHECK(error_of(idle({1, 0, 0}), "elastic_666") == 0);
}

TEST_CASE("a turning body's energy") {
  Scene scene{{{.solid = {.half_extents = {1, 2, 3}}, .mass = 6}}};
  std::vector<State> states = at_start(scene);
  const double quarter = std::sqrt(0.5);
  states[0].orientation = glm::dquat(quarter, 0, 0, quarter);  // x is the world's y
  states[0].angular_velocity = {0, 2, 0};
  states[0].position = {0, 1, 0};

  // I_x = m/3 (2² + 3²) = 26 kg m²
  CHECK(std::abs(energy(scene, states) - (26 * 4 / 2.0 + 6 * 9.81)) < 64 * k_u * 111);
}

TEST_CASE("depths of overlapping pairs are those of their shapes") {
  const Solid ball{.radius = 0.5}, box{.half_extents = {0.5, 0.5, 0.5}};
  for (const auto& [a, b] : {std::pair(ball, ball), {ball, box}, {box, box}}) {
    const Scene deep = pair_of(a, b, {0.9, 0, 0}), apart = pair_of(a, b, {1.1, 0, 0});
    const Overlaps found = overlaps(deep, at_start(deep));
    CHECK(std::abs(found.worst - 0.1) < 64 * k_u);
    CHECK(std::abs(found.sum_of_squares - 0.01) < 64 * k_u);
    CHECK(overlaps(apart, at_start(apart)).worst == 0);
  }
}

// But for bodies that stand on each other: what their coordinates are rounded to
TEST_CASE("no scene starts in itself") {
  CHECK(column().bodies.size() == 1 + 10);
  CHECK(pyramid().bodies.size() == 1 + 210);
  CHECK(pile().bodies.size() == 1 + 1000);
  for (const Scene& scene : {column(), pyramid(), pile(), bouncing_ball(),
                             sliding_block(), elastic_gas(), bouncing()})
    CHECK(overlaps(scene, at_start(scene)).worst < 64 * k_u * 20);
  for (const SimbenchScene& one : simbench_scenes(false))
    CHECK(overlaps(one.scene, at_start(one.scene)).worst < 64 * k_u * 20);
}

TEST_CASE("a library that gives up has no error") {
  const auto make = [](const Scene& scene, const Settings&) {
    const auto give_up = [] { throw std::runtime_error("too much"); };
    return Simulation{give_up, [=] { return at_start(scene); }};
  };
  CHECK(std::isnan(error_of({.name = "weak", .make = make}, "rolling")));
}
