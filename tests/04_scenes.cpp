// Chapter 4's scenes, as a program would drive them. Compiled for each precision.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>

#include "chapters/04-contacts/concave_mesh.hpp"
#include "chapters/04-contacts/scenes.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_04::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;

// Rounding of a pair about 1 m in size: 16 roundings of its points in the difference,
// which is up to 4 m wide, and as many of the coordinates that are rounded to Real
constexpr double k_rounded = 2 * 16 * 4 * k_u;

std::unique_ptr<Simulation> run_steps(const std::string& name,
                                      const std::string& method, double steps,
                                      const Changes& changes = {},
                                      const char* mesh = "") {
  const Scene scene = scene_of(name);
  Setup setup = setup_of(scene, method, changes);
  setup.mesh = mesh;
  return run_for(scene, setup, steps * scene.dt);
}

// All of the scene
std::unique_ptr<Simulation> run_all(const std::string& name, const std::string& method,
                                    const Changes& changes = {},
                                    const char* mesh = "") {
  const Scene scene = scene_of(name);
  return run_steps(name, method, scene.duration / scene.dt, changes, mesh);
}

std::map<std::string, double> preset(const std::string& scene,
                                     const std::string& name) {
  for (const Preset& p : scene_of(scene).presets)
    if (p.name == name) return p.values;
  throw InputError("no preset " + name);
}

Changes spheres(double from, double to) {
  return {{"a", 0}, {"b", 0}, {"from", from}, {"to", to}, {"offset", 0}};
}

}  // namespace

TEST_CASE("every scene runs, stays finite and gives the same again") {
  for (const Scene& scene : chapter_04::scenes()) {
    for (const std::string& method : scene.default_methods) {
      INFO(scene.name << ", " << method);
      const char* const mesh = scene.takes_mesh ? "chair.obj" : "";
      const auto before = run_steps(scene.name, method, 0, {}, mesh)->metrics();
      const auto one = run_steps(scene.name, method, 10, {}, mesh);
      const auto two = run_steps(scene.name, method, 10, {}, mesh);
      const std::vector<Metric> after = one->metrics(), again = two->metrics();
      REQUIRE(after.size() == before.size());
      for (std::size_t i = 0; i < after.size(); ++i) {
        CHECK(after[i].name == before[i].name);
        CHECK(std::isfinite(after[i].value));
        CHECK(after[i].value == again[i].value);
      }
      DrawList list;
      one->draw_reference(list);
      one->draw(list);
      CHECK(list.shapes.size() + list.meshes.size() + list.balls.size() >= 2);
    }
  }
}

TEST_CASE(
    "a step is an iteration, and the bounds close around the whole query's answer") {
  for (const char* name :
       {"separated", "touching", "overlapping", "coincident", "plane", "round"}) {
    INFO(name);
    double gap = std::numeric_limits<double>::infinity();
    int steps = 0;
    const Scene scene = scene_of("step-by-step");
    const auto simulation =
        scene.start(setup_of(scene, "gjk_epa", preset("step-by-step", name)));
    for (; metric(*simulation, "done") == 0; ++steps) {
      REQUIRE(steps < 600);
      CHECK(metric(*simulation, "iterations") == steps);
      simulation->step();
      simulation->observe();
      gap = metric(*simulation, "gap");
    }

    // What it ends with is what separation() answers, by the same steps
    CHECK(std::abs(metric(*simulation, "distance")
                   - metric(*simulation, "distance_final"))
          <= k_rounded);
    CHECK(gap == 0);
    simulation->step();
    CHECK(metric(*simulation, "iterations") == steps);
  }
}

TEST_CASE("iterations can be done beforehand") {
  for (int from = 0; from < 9; ++from) {
    const auto ahead = run_steps("step-by-step", "gjk_epa", 9 - from, {{"from", from}});
    const auto all = run_steps("step-by-step", "gjk_epa", 9);
    for (const Metric& m : all->metrics()) CHECK(metric(*ahead, m.name) == m.value);
  }
}

TEST_CASE("each step tells in words what it does") {
  DrawList first, last;
  run_steps("step-by-step", "gjk_epa", 0)->draw(first);
  run_steps("step-by-step", "gjk_epa", 12)->draw(last);
  REQUIRE(first.caption.size() == 2);
  REQUIRE(last.caption.size() == 2);
  CHECK(first.caption[0].find("GJK, step 0: of a point") == 0);
  CHECK(last.caption[0].find("EPA, step 9") == 0);
  CHECK(last.caption[1].find("that is the depth") != std::string::npos);
}

TEST_CASE("two boxes a place apart touch along their faces") {
  // 1 m wide, centres 1 m apart along x: all of these numbers are exact
  const auto simulation =
      run_steps("step-by-step", "gjk_epa", 12, preset("step-by-step", "touching"));
  CHECK(std::abs(metric(*simulation, "distance_final")) <= k_rounded);
}

TEST_CASE("spheres in the sweep are as far apart as their centres say") {
  for (const char* method : {"gjk_epa", "closed_form"}) {
    // From 1.6 m beside A, through it, to 1.6 m on the other side
    const auto simulation = run_all("sweep", method, spheres(-1.6, 1.6));
    CHECK(std::abs(metric(*simulation, "distance") - 0.6) <= k_rounded);
    CHECK(metric(*simulation, "relative_error_max") <= 2 * k_rounded);
    CHECK(metric(*simulation, "witness_fault_max") <= k_rounded);
    CHECK(metric(*simulation, "overlap_fault_max") <= k_rounded);
    CHECK(metric(*simulation, "wrong_states") == 0);
    CHECK(metric(*simulation, "unanswered") == 0);

    // Straight through the middle the normal turns over at once
    CHECK(metric(*simulation, "normal_jump_max") > 1.5);
    CHECK(metric(*simulation, "distance_jump_max") <= k_rounded);
  }
}

TEST_CASE("beside the middle, the normal of spheres turns as the path says") {
  const double offset = 0.3, step = 3.2 / 240;
  Changes path = spheres(-1.6, 1.6);
  path["offset"] = offset;
  const auto simulation = run_all("sweep", "closed_form", path);

  // Most right above, from half a step before to half a step after: a step of x turns
  // it by at most atan(step / 2 / offset) twice
  const double most = 2 * std::atan(step / 2 / offset);
  CHECK(metric(*simulation, "normal_jump_max") <= most + k_rounded / offset);
  CHECK(metric(*simulation, "normal_jump_max") >= 0.99 * most);
}

TEST_CASE("GJK with EPA and separating axes agree along the whole path") {
  for (const char* pair : {"hulls", "aligned"}) {
    for (const char* method : {"gjk_epa", "sat"}) {
      INFO(pair << ", " << method);
      const auto simulation = run_all("sweep", method, preset("sweep", pair));
      CHECK(metric(*simulation, "depth_error_max") <= k_rounded);
      CHECK(metric(*simulation, "distance_error_max") <= k_rounded);
      CHECK(metric(*simulation, "overlap_fault_max") <= k_rounded);
      CHECK(metric(*simulation, "wrong_states") == 0);
      CHECK(metric(*simulation, "distance_jump_max") <= k_rounded);
    }
  }
}

TEST_CASE("MPR's depth of boxes is not the least, and jumps") {
  const auto simulation = run_all("sweep", "libccd_mpr");
  CHECK(metric(*simulation, "depth_error_max") > 0.1);
  CHECK(metric(*simulation, "distance_jump_max") > 0.1);
}

TEST_CASE("the sweep is the same for every size, far more than a few roundings") {
  for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
    const auto simulation = run_all("sweep", "gjk_epa", {{"size", size / 2}});
    CHECK(metric(*simulation, "relative_error_max") <= 2 * k_rounded);
    CHECK(metric(*simulation, "wrong_states") == 0);
  }
}

TEST_CASE("a pair that a method does not take stops it, in words") {
  const Scene scene = scene_of("sweep");
  const auto closed = scene.start(setup_of(scene, "closed_form"));
  CHECK_THROWS_AS(closed->step(), StepFailure);
  const auto far =
      scene.start(setup_of(scene, "gjk_epa", {{"size", 1e300}, {"ratio", 1e9}}));
  CHECK_THROWS_AS(far->step(), StepFailure);
}

TEST_CASE("all pairs of eight shapes come into contact, and are answered right") {
  const auto simulation = run_all("pairs", "gjk_epa");
  CHECK(metric(*simulation, "pairs") == 35);
  CHECK(metric(*simulation, "pairs_taken") == 35);
  CHECK(metric(*simulation, "unanswered") == 0);
  CHECK(metric(*simulation, "wrong_states") == 0);
  CHECK(metric(*simulation, "pairs_in_contact") > 5);
  CHECK(metric(*simulation, "contact_points")
        >= metric(*simulation, "pairs_in_contact"));
  CHECK(metric(*simulation, "witness_fault_max") <= k_rounded);
  CHECK(metric(*simulation, "distance_error_max") <= 8 * k_rounded);
}

TEST_CASE("closed forms and separating axes take the pairs that they are for") {
  // Spheres with spheres, boxes, capsules and cylinders; capsules; seven with the
  // half-space
  CHECK(metric(*run_steps("pairs", "closed_form", 1), "pairs_taken") == 4 + 1 + 7);
  CHECK(metric(*run_steps("pairs", "sat", 1), "pairs_taken") == 2);
}

TEST_CASE("a chair's parts are its volume, its hull is far more") {
  if (!can_load_meshes()) return;

  // Six boxes
  const double volume = 0.4 * 0.03 * 0.4 + 0.39 * 0.45 * 0.025 + 4 * 0.04 * 0.42 * 0.04;
  const Changes under{{"height", -0.3}};
  const auto authored = run_all("mesh", "authored", under, "chair.obj");
  CHECK(metric(*authored, "parts") == 6);
  CHECK(metric(*authored, "faces") == 36);

  // The file's coordinates are floats, to half a unit in 2^24 of up to 0.9 m; the
  // thinnest side is 0.025 m
  const double loaded = 3 * 0.9 / 0.025 * std::ldexp(1.0, -24) + 64 * k_u;
  CHECK(metric(*authored, "mesh_volume") == Approx(volume).epsilon(loaded));
  CHECK(metric(*authored, "parts_volume") == Approx(volume).epsilon(loaded));
  CHECK(metric(*authored, "false_contacts") == 0);
  CHECK(metric(*authored, "contact_steps") == 0);

  const auto hull = run_all("mesh", "hull", under, "chair.obj");
  CHECK(metric(*hull, "parts") == 1);
  CHECK(metric(*hull, "false_contacts") == metric(*hull, "contact_steps"));
  CHECK(metric(*hull, "false_contacts") > 100);
  CHECK(metric(*hull, "hull_volume") == metric(*hull, "parts_volume"));

  const auto cut = run_all("mesh", "decomposition", under, "chair.obj");
  CHECK(metric(*cut, "parts_volume") > volume * (1 - loaded));
  CHECK(metric(*cut, "parts_volume") < 1.3 * volume);
  CHECK(metric(*cut, "false_contacts") == 0);
}

TEST_CASE("no way to hold a mesh misses a contact") {
  if (!can_load_meshes()) return;
  for (const char* method : {"hull", "decomposition"}) {
    const auto simulation = run_all("mesh", method, {}, "wrench.obj");
    CHECK(metric(*simulation, "missed_contacts") == 0);
    CHECK(metric(*simulation, "mesh_contact_steps") > 20);
    CHECK(metric(*simulation, "contact_steps")
          >= metric(*simulation, "mesh_contact_steps"));
  }
}

TEST_CASE("how far a point is from a mesh, inside and outside") {
  if (!can_load_meshes()) return;

  // The cube of 1 m, moved to its middle
  const chapter_04::ConcaveMesh cube = chapter_04::load_concave("cube.obj");
  const double half = double(cube.half_extents.x);
  CHECK(cube.pieces.size() == 1);
  const auto at = [&](double x) {
    return chapter_04::distance_to_mesh(cube, Vec3(x * half, 0, 0));
  };
  CHECK(at(0) == Approx(-half).epsilon(8 * k_u));
  CHECK(at(0.75) == Approx(-half / 4).epsilon(32 * k_u));
  CHECK(at(1.5) == Approx(half / 2).epsilon(16 * k_u));
  CHECK(at(3) == Approx(2 * half).epsilon(8 * k_u));
  CHECK(chapter_04::load_concave("chair.obj").pieces.size() == 6);
}
