// Chapter 3's scenes, as a program would drive them. Compiled for each precision.
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "chapters/03-rigid-bodies/scenes.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_03::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr bool k_double = std::numeric_limits<Real>::digits > 24;

// What one step may round, in units of u and of the size of what is stepped: some forty
// additions and multiplications, for the methods without an equation to solve
constexpr double k_step = 40;

}  // namespace

TEST_CASE("every scene runs with every method and stays finite") {
  for (const Scene& scene : tested_scenes()) {
    for (const Method& method : scene.methods) {
      INFO(scene.name << ", " << method.name);
      const auto before = scene.start(setup_of(scene, method.name))->metrics();
      const auto simulation =
          run_for(scene, setup_of(scene, method.name), 30 * scene.dt);
      const std::vector<Metric> after = simulation->metrics();
      REQUIRE(after.size() == before.size());
      for (std::size_t i = 0; i < after.size(); ++i) {
        CHECK(after[i].name == before[i].name);
        CHECK(std::isfinite(after[i].value));
      }
      REQUIRE(simulation->bodies().size() == 1);
      CHECK(simulation->bodies()[0].orientation.has_value());
    }
  }
}

TEST_CASE("every method looks different") {
  std::set<std::pair<std::string, MarkerShape>> looks;
  const Scene scene = scene_of("torque-free");
  for (const Method& method : scene.methods)
    looks.emplace(std::to_string(method.style.color.r) + " "
                      + std::to_string(method.style.color.g) + " "
                      + std::to_string(method.style.color.b),
                  method.style.marker);
  CHECK(looks.size() == scene.methods.size());
}

TEST_CASE("the centre of mass of a mesh flies semi-implicit Euler's parabola") {
  const double dt = 1.0 / 120;
  for (const char* method : {"listing_3", "splitting", "rk4"}) {
    const auto simulation = run("thrown-wrench", method, dt, 0.5);

    // Chapter 1: off by g dt t / 2, downwards. Speeds of 3 m/s and places of 1 m round
    // to 4 u in each of 60 steps
    CHECK(metric(*simulation, "position_error")
          == Approx(9.81 * dt * 0.5 / 2).margin(4 * 60 * 4 * k_u));
  }
}

TEST_CASE("a mesh tumbles as its moments say") {
  // Second order: half the step, a quarter of the error. In single, while the error is
  // far above the rounding of all steps
  const double coarse =
      metric(*run("thrown-wrench", "splitting", 1.0 / 120, 0.6), "attitude_error");
  const double fine =
      metric(*run("thrown-wrench", "splitting", 1.0 / 240, 0.6), "attitude_error");
  CHECK(std::log2(coarse / fine) == Approx(2).margin(k_double ? 0.05 : 0.1));

  // Listing 3 is off, and no step helps
  const double listing =
      metric(*run("thrown-wrench", "constant_omega", 1.0 / 960, 0.6), "attitude_error");
  CHECK(listing > 0.5);
}

TEST_CASE("energy and the length of L are blind to Listing 3, its direction is not") {
  const int n = 600;
  const auto simulation = run("torque-free", "listing_3", 1.0 / 60, n / 60.0);
  CHECK(metric(*simulation, "energy_error_max") <= 2 * k_step * n * k_u);
  CHECK(metric(*simulation, "momentum_length_error_max") <= k_step * n * k_u);

  // omega and L are 0.195 rad apart: L goes round omega, up to twice that from its
  // start
  CHECK(metric(*simulation, "momentum_direction_error_max")
        == Approx(2 * 0.19516).margin(1e-3));
  CHECK(metric(*simulation, "attitude_error") > 1);
}

TEST_CASE("the flips of a minute are counted right by the methods that leak nothing") {
  for (const char* method : {"explicit_midpoint_su2", "lie_midpoint", "splitting",
                             "discrete_moser_veselov"}) {
    INFO(method);
    const auto simulation = run("dzhanibekov", method, 1.0 / 60, 60);
    CHECK(metric(*simulation, "flips_exact") == 21);
    CHECK(metric(*simulation, "flips") == 21);

    // Truth's interval; the methods' own differ in the second order of 10 rad/s / 60 Hz
    CHECK(metric(*simulation, "flip_interval_exact")
          == Approx(2.898577664).epsilon(1e-9));
    CHECK(metric(*simulation, "flip_interval") == Approx(2.8986).epsilon(0.01));
  }
  CHECK(metric(*run("dzhanibekov", "listing_3", 1.0 / 60, 60), "flips") == 0);
}

TEST_CASE("a free symmetric top goes round L at |L| / I1") {
  const auto off = [](double dt) {
    const auto simulation = run("symmetric-top", "splitting", dt, 5);
    return metric(*simulation, "precession_rate")
           - metric(*simulation, "precession_rate_exact");
  };
  CHECK(metric(*run("symmetric-top", "rk4", 1.0 / 60, 1), "precession_rate_exact")
        == Approx(std::hypot(3, 2.5)).epsilon(1e-14));

  // Its mean rate has an error of second order, and one that depends on where in a turn
  // the run ends
  CHECK(std::abs(off(1.0 / 60)) < 2e-3);
  CHECK(std::abs(off(1.0 / 240)) < 2e-3 / 8);
}

TEST_CASE("a heavy top nods between its two tilts, and keeps its upright momentum") {
  const int n = 1200;
  const auto simulation = run("heavy-top", "splitting", 1.0 / 240, n / 240.0);

  // Truth's range of tilt, to the second order of 60 rad/s / 240 Hz times its range
  CHECK(metric(*simulation, "tilt_max_exact")
        == Approx(1.1192555046664143).epsilon(1e-13));
  CHECK(metric(*simulation, "tilt_max") == Approx(1.1192555).margin(1e-3));
  CHECK(metric(*simulation, "tilt_min") == Approx(0.5).margin(1e-3));

  // A kick along the horizontal, and turns: rounding alone, of L of 0.6 kg m²/s
  CHECK(metric(*simulation, "vertical_momentum_error_max")
        <= 3 * k_step * n * k_u * 0.6);
  CHECK(metric(*run("heavy-top", "implicit_gyroscopic", 1.0 / 240, 5), "tilt_max") > 3);
}

TEST_CASE("a struck ball ends with five sevenths of its speed, and of its spin two") {
  const double v0 = 0.3 / 0.17;
  const auto simulation = run("cue-strike", "listing_3", 1.0 / 240, 0.8);

  // (3.35), exact whatever the step, since friction keeps 5 v + 2 r omega
  const double omega0 = -0.01 * v0 / (0.4 * 0.028575 * 0.028575);
  const double rolling = (5 * v0 + 2 * 0.028575 * omega0) / 7;
  const double rounding = 8 * 192 * k_u * v0;
  CHECK(metric(*simulation, "speed") == Approx(rolling).margin(rounding));
  CHECK(metric(*simulation, "topspin")
        == Approx(rolling / 0.028575).margin(rounding / 0.028575));
  CHECK(metric(*simulation, "slip") <= rounding);

  // The strike's step has no friction, and rolling is seen at the end of a step
  const double late =
      metric(*simulation, "rolling_time") - metric(*simulation, "rolling_time_exact");
  CHECK(late > 0);
  CHECK(late < 2.0 / 240 + 1e-6);
}

TEST_CASE("a ball struck at two fifths of its radius rolls at once") {
  const auto simulation = run("cue-strike", "momentum", 1.0 / 240, 0.5,
                              {{"above", 0.4 * 0.028575}, {"aside", 0}});
  CHECK(metric(*simulation, "rolling_time") == 1.0 / 240);
  CHECK(metric(*simulation, "rolling_height") == Approx(0.01143).epsilon(1e-14));
}

TEST_CASE("a wheel under a steady torque") {
  const double dt = 1.0 / 60;
  const int n = 300;
  const double alpha = 1 / 0.5;
  const double t = n * dt;
  const double rounding = k_step * n * k_u * t * alpha;

  // Euler is half a step ahead; half a kick at either end is exact
  CHECK(metric(*run("spin-up", "momentum", dt, t), "angle_error")
        == Approx(alpha * dt * t / 2).margin(rounding));
  CHECK(std::abs(metric(*run("spin-up", "splitting", dt, t), "angle_error"))
        <= rounding);

  // Listing 3 loses (omega dt)³ / 12 of that in each step: 2 atan in place of the angle
  double lost = 0;
  for (int k = 1; k <= n; ++k)
    lost += k * alpha * dt * dt - 2 * std::atan(k * alpha * dt * dt / 2);
  CHECK(metric(*run("spin-up", "listing_3", dt, t), "angle_error")
        == Approx(alpha * dt * t / 2 - lost).margin(rounding));

  // Damping once a step is of first order
  const Changes damped{{"damping", 0.5}};
  const double coarse =
      metric(*run("spin-up", "splitting", dt, t, damped), "angular_velocity_error");
  const double fine =
      metric(*run("spin-up", "splitting", dt / 2, t, damped), "angular_velocity_error");
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.02));
}

TEST_CASE("a step without a solution is said, not hidden") {
  const Scene scene = scene_of("torque-free");
  Setup setup = setup_of(scene, "discrete_moser_veselov", {{"omega1", 1000}});
  const auto simulation = scene.start(setup);
  CHECK_THROWS_AS(simulation->step(), StepFailure);
}

TEST_CASE("what cannot be is refused in one line") {
  const auto refuses = [](const std::string& name, const Changes& changes) {
    const Scene scene = scene_of(name);
    CHECK_THROWS_AS(scene.start(setup_of(scene, "splitting", changes)), InputError);
  };
  refuses("torque-free", {{"i1", 5}});
  refuses("dzhanibekov", {{"i2", 4}});
  refuses("symmetric-top", {{"i3", 2.5}});
  refuses("heavy-top", {{"i1", 0.04}});
  refuses("cue-strike", {{"above", 0.03}});
}
