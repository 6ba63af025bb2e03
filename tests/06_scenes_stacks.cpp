// Chapter 6's scenes of stacks and piles, as a program would drive them. Compiled for
// each precision.
#include <cmath>
#include <limits>
#include <set>

#include "chapters/06-impulses/scenes.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_06::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr double k_60_hz = 1.0 / 60;

}  // namespace

TEST_CASE("scenes of friction and of stacks stay finite and give the same again") {
  for (const char* name : {"ramp", "slide-to-roll", "rod", "rocking-block", "stack",
                           "pyramid", "pile", "mass-ratio"}) {
    const Scene scene = scene_of(name);
    for (const Method& method : scene.methods) {
      if (method.name == "lcp" && std::string(name).starts_with("p")) continue;
      INFO(name << ", " << method.name);
      const auto one = run(name, method.name, scene.dt, 3 * scene.dt);
      const auto two = run(name, method.name, scene.dt, 3 * scene.dt);
      const std::vector<Metric> first = one->metrics(), again = two->metrics();
      REQUIRE(first.size() == again.size());
      for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(std::isfinite(first[i].value));
        CHECK(first[i].value == again[i].value);
      }
      DrawList list;
      one->draw_reference(list);
      one->draw(list);
      CHECK(!list.shapes.empty());
    }
  }
}

TEST_CASE("a stack of ten stands and hardly leans") {
  const auto stack = run("stack", "substeps", k_60_hz, 10);
  CHECK(metric(*stack, "stood_until") == Approx(10));

  // A twentieth of what would tip the uppermost box
  CHECK(metric(*stack, "drift_max") < 0.05 / 2);
  CHECK(metric(*stack, "energy_change") <= 64 * k_u * 10);
}

TEST_CASE("boxes that stand too far aside fall, and the scene says so") {
  // Each overhangs the one below by more than half
  const auto stack =
      run("stack", "substeps", k_60_hz, 2, {{"n", 3}, {"aside", 0.5}, {"gap", 0.1}});
  CHECK(metric(*stack, "fallen") == 1);
  CHECK(metric(*stack, "stands") == 0);
}

TEST_CASE("a small stack is held by the direct solver where it was put") {
  const auto stack = run("stack", "lcp", k_60_hz, 2, {{"n", 3}});

  // The slop of each of three contacts is all that it may sink; on one side alone it
  // tilts what is above, whose top is 2.5, 1.5 and 0.5 high
  CHECK(metric(*stack, "sunk") <= 3 * 5e-4 + 64 * k_u);
  CHECK(metric(*stack, "drift_max") <= (2.5 + 1.5 + 0.5) * 5e-4 + 64 * k_u);
}

TEST_CASE("what holds a heavy box on a light one is their weight") {
  for (const char* method : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(method);
    const auto boxes = run("mass-ratio", method, k_60_hz, 10, {{"ratio", 1}});
    CHECK(metric(*boxes, "stands") == 1);

    // At rest impulses balance gravity but for what the boxes still move
    const double moves = metric(*boxes, "fastest") / (9.81 * k_60_hz / 4);
    CHECK(std::abs(metric(*boxes, "impulse_error")) <= 2 * moves + 1e-3);
  }
}

TEST_CASE(
    "too heavy a box sinks through where sweeps end early, not in the direct one") {
  const Changes heavy{{"ratio", 1e4}};
  CHECK(metric(*run("mass-ratio", "sequential_impulses", k_60_hz, 3, heavy), "fallen")
        == 1);
  if (sizeof(Real) == sizeof(double))
    CHECK(metric(*run("mass-ratio", "lcp", k_60_hz, 3, heavy), "sunk") < 0.01);
}

TEST_CASE("a pyramid keeps its shape") {
  const auto pyramid = run("pyramid", "substeps", k_60_hz, 3, {{"base", 8}});
  CHECK(metric(*pyramid, "stood_until") == Approx(3));

  // Neighbours leave a gap of a tenth: two that drift by half of it meet. A contact may
  // be as deep as the margin within which it is looked for
  CHECK(metric(*pyramid, "drift_max") < 0.1 / 2);
  CHECK(metric(*pyramid, "penetration_max") < 0.01);
}

TEST_CASE("a pile comes to rest, and chance depends on its seed alone") {
  const auto pile = run("pile", "substeps", k_60_hz, 8, {{"n", 30}, {"balls", 0}});
  CHECK(metric(*pile, "moves_until") < 8);

  // No deeper than the margin within which contacts are looked for
  CHECK(metric(*pile, "penetration") < 0.01);

  std::set<double> energies;
  for (const double seed : {1.0, 1.0, 2.0, 3.0}) {
    const auto start = run("pile", "substeps", k_60_hz, k_60_hz,
                           {{"n", 30}, {"seed", seed}, {"balls", 0.5}});
    energies.insert(metric(*start, "momentum") + start->bodies()[3].position.x);
  }
  CHECK(energies.size() == 3);
}
