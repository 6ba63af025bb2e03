// Chapter 2's scenes, as a program would drive them. Compiled for each precision.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "chapters/02-verlet/scenes.hpp"
#include "common/physics/exact_pendulum.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_02::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr bool k_double = std::numeric_limits<Real>::digits > 24;
constexpr double k_g = 9.81;

// By which power of dt a metric falls when the step is halved
double slope(const std::string& scene, const std::string& method,
             const std::string& name, double dt, double seconds,
             const Changes& changes = {}) {
  const double coarse = metric(*run(scene, method, dt, seconds, changes), name);
  const double fine = metric(*run(scene, method, dt / 2, seconds, changes), name);
  return std::log2(std::abs(coarse / fine));
}

}  // namespace

TEST_CASE("ropes and double pendulums run with every method and stay finite") {
  for (const char* name : {"double-pendulum", "rope"}) {
    const Scene scene = scene_of(name);
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

      DrawList list;
      simulation->draw(list);
      simulation->draw_reference(list);
      CHECK_FALSE((list.lines.empty() || list.balls.empty()));
    }
  }
}

TEST_CASE("the double pendulum's reference is the one of tests/truth") {
  // Kind double_pendulum_reference: all of length 1 and mass 1, from 2 and 1 rad
  struct Truth {
    double t, theta1, theta2;
  };
  for (const auto& [t, theta1, theta2] :
       {Truth{0.5, 0.7895563616136629, 1.0394126791374187},
        Truth{2, -0.6437304459843478, -1.7660899605606544},
        Truth{5, -0.6018013849015591, -3.1564509985041633}}) {
    const auto simulation = run("double-pendulum", "rk4", 1.0 / 60, t);
    CHECK(std::abs(metric(*simulation, "theta1_reference") - theta1) <= 1e-9);
    CHECK(std::abs(metric(*simulation, "theta2_reference") - theta2) <= 1e-9);
    CHECK(metric(*simulation, "reference_uncertainty") <= 1e-9);
  }
}

TEST_CASE("the reference is good for the scene's duration, and says when it is not") {
  const double planned = scene_of("double-pendulum").duration;
  const auto uncertainty_after = [](double seconds) {
    return metric(*run("double-pendulum", "rk4", 1.0 / 60, seconds),
                  "reference_uncertainty");
  };
  CHECK(uncertainty_after(planned) < 1e-7);
  CHECK(uncertainty_after(40) > 0.1);
}

TEST_CASE("small swings of a double pendulum are its two normal modes") {
  // Equal masses and rods: theta2 = +-sqrt(2) theta1, omega² = (2 -+ sqrt(2)) g / l.
  // In 2 s the phase is off by 1e-7 through RK4 at omega dt < 0.03, and by 12 rad times
  // angle² through the sine; each step rounds angle and rate, up to 6/s times as large
  constexpr double k_small = 1e-4;
  constexpr int k_steps = 400;
  constexpr double k_seconds = k_steps / 200.0;
  constexpr double k_allowed = k_small * (4e-7 + 2 * 6 * k_steps * k_u);
  for (const double ratio : {std::numbers::sqrt2, -std::numbers::sqrt2}) {
    const auto simulation =
        run("double-pendulum", "rk4", k_seconds / k_steps, k_seconds,
            {{"theta1", k_small}, {"theta2", ratio * k_small}, {"gravity", k_g}});
    const double theta1 = k_small * std::cos(std::sqrt((2 - ratio) * k_g) * k_seconds);
    CHECK(std::abs(metric(*simulation, "theta1") - theta1) <= k_allowed);
    CHECK(std::abs(metric(*simulation, "theta2") - ratio * theta1) <= 2 * k_allowed);
  }
}

TEST_CASE("orders where the acceleration depends on the velocity") {
  const std::map<std::string, int> orders{
      {"explicit_euler", 1},
      {"semi_implicit_euler", 1},
      {"velocity_verlet", 1},
      {"verlet_half", 1},
      {"verlet_predicted", 2},
      {"verlet_implicit", 2},
      {"midpoint", 2},
      {"heun", 2},
      {"rk4", 4},
      {"dopri5", 5},
      {"implicit_euler", 1},
      {"implicit_midpoint", 2},
      {"implicit_trapezoid", 2},
  };
  for (const auto& [method, order] : orders) {
    INFO(method);
    if (order > 2 && !k_double) continue;  // rounding hides them
    const double dt = 1.0 / 128;
    CHECK(slope("double-pendulum", method, "state_error", dt, 1)
          == Approx(order).margin(0.25));
    if (method.starts_with("verlet") || method == "velocity_verlet")
      CHECK(slope("double-pendulum", method, "energy_error", dt, 1)
            == Approx(order).margin(0.25));
  }
}

TEST_CASE("a double pendulum that hangs at rest has no energy and no error") {
  const auto simulation =
      run("double-pendulum", "rk4", 1.0 / 60, 1, {{"theta1", 0}, {"theta2", 0}});
  CHECK(metric(*simulation, "state_error_max") == 0);
  CHECK(metric(*simulation, "energy_error_max") == 0);
}

TEST_CASE("rods keep their lengths, the better the more often they are asked") {
  const auto stretch_after = [](double iterations) {
    return metric(*run("rope", "distance_constraints", 1.0 / 120, 4,
                       {{"iterations", iterations}}),
                  "stretch_max");
  };
  CHECK(stretch_after(10) < 0.02);
  CHECK(stretch_after(100) < 0.001);

  // Places up to 2 m are rounded, links are 2/11 m long
  CHECK(stretch_after(10'000) < 8 * 11 * k_u);
}

TEST_CASE("one rod is a pendulum of first order, braked by its own pull") {
  // The pull T = m (L omega² + g cos theta) along the rod at the end of a step is
  // turned by omega dt against the motion: energy leaves at the rate T L omega² dt
  constexpr double k_length = 2;
  const double omega0 = std::sqrt(k_g / k_length);
  const exact::Coordinate start{std::numbers::pi / 2, 0};
  const auto lost_by = [&](double dt, double seconds) {
    double sum = 0;
    for (int i = 0; (i + 0.5) * dt < seconds; ++i) {
      const auto [theta, omega] = exact::pendulum(start, omega0, (i + 0.5) * dt);
      sum += dt * omega * omega * (omega * omega / (omega0 * omega0) + std::cos(theta));
    }
    return sum * dt;
  };

  const Changes one_rod{{"particles", 2}, {"iterations", 1}, {"length", k_length}};
  const double dt = 1.0 / 480;
  const auto rope = run("rope", "distance_constraints", dt, 1, one_rod);
  CHECK(metric(*rope, "energy_error") == Approx(-lost_by(dt, 1)).epsilon(0.05));

  const auto error_at = [&](double step) {
    const double theta = exact::pendulum(start, omega0, 1).x;
    const auto swing = run("rope", "distance_constraints", step, 1, one_rod);
    return metric(*swing, "tip_x") - k_length * std::sin(theta);
  };
  CHECK(std::log2(error_at(dt) / error_at(dt / 2)) == Approx(1).margin(0.1));
}

TEST_CASE("two rods are a double pendulum, to first order") {
  const auto distance_at = [](double dt) {
    const auto rope =
        run("rope", "distance_constraints", dt, 0.5,
            {{"particles", 3}, {"iterations", 100}, {"angle", 1}, {"length", 2}});
    const auto pendulum =
        run("double-pendulum", "rk4", dt, 0.5, {{"theta1", 1}, {"theta2", 1}});
    return glm::distance(rope->bodies().back().position,
                         pendulum->bodies().back().position);
  };

  // Störmer's rounding grows with the square of the steps: not too many in single
  const double dt = k_double ? 1.0 / 480 : 1.0 / 60;
  CHECK(distance_at(dt) < dt);
  CHECK(std::log2(distance_at(dt) / distance_at(dt / 2)) == Approx(1).margin(0.1));
}

TEST_CASE("rods are implicit Euler's springs without end of stiffness") {
  const auto rods =
      run("rope", "distance_constraints", 1.0 / 120, 2, {{"iterations", 1000}});
  const auto springs =
      run("rope", "implicit_euler", 1.0 / 120, 2, {{"stiffness", 1e5}});
  CHECK(metric(*rods, "energy_error") < -0.1);
  CHECK(metric(*rods, "energy_error")
        == Approx(metric(*springs, "energy_error")).epsilon(0.02));
}

TEST_CASE("order of the energy's error in a swinging rope") {
  const std::map<std::string, int> orders{{"distance_constraints", 1},
                                          {"semi_implicit_euler", 1},
                                          {"implicit_euler", 1},
                                          {"velocity_verlet", 2},
                                          {"rk4", 4}};
  for (const auto& [method, order] : orders) {
    INFO(method);
    if (order > 2 && !k_double) continue;  // rounding hides it
    const double dt = order > 2 ? 1.0 / 960 : 1.0 / 240;
    CHECK(slope("rope", method, "energy_error", dt, 0.5) == Approx(order).margin(0.2));
  }
}

TEST_CASE("springs hold below omega dt = 2 and tear above") {
  for (const char* method : {"semi_implicit_euler", "velocity_verlet"}) {
    const auto stretch_at = [&](double omega_dt) {
      const double k = std::pow(omega_dt * 120 / 2, 2) / 11;
      const auto rope = run("rope", method, 1.0 / 120, 4, {{"stiffness", k}});
      CHECK(metric(*rope, "omega_dt") == Approx(omega_dt));
      return metric(*rope, "stretch_max");
    };
    CHECK(stretch_at(1.9) < 1);
    CHECK(stretch_at(2.1) > 1e6);
  }
}

TEST_CASE("a rope's momentum changes by its weight and the held end's pull alone") {
  // Eleven particles of 1/11 kg, links of 2/11 m; a step rounds momenta of up to 10 N s
  // and places of 2 m, which 1000 N/m over dt turn into momentum
  constexpr double k_dt = 1.0 / 120;
  const Scene scene = scene_of("rope");
  const auto rope = scene.start(setup_of(scene, "semi_implicit_euler"));
  rope->observe();
  const auto momentum = [&] {
    glm::dvec3 sum{0};
    for (const BodyState& body : rope->bodies()) sum += body.velocity / 11.0;
    return sum;
  };
  for (int i = 0; i < 240; ++i) {
    const glm::dvec3 first = rope->bodies()[1].position;
    const glm::dvec3 pull = -1e3 * (1 - 2.0 / 11 / glm::length(first)) * first;
    const glm::dvec3 expected = momentum() + k_dt * (glm::dvec3(0, -k_g, 0) + pull);
    rope->step();
    rope->observe();
    REQUIRE(glm::distance(momentum(), expected) <= 4 * k_u * (10 + 1e3 * 2 * k_dt));
  }
}

TEST_CASE("ropes of extremes come to an end, and rods stay finite") {
  const std::vector<Changes> extremes{{{"particles", 2}},    {{"iterations", 1}},
                                      {{"stiffness", 1e12}}, {{"gravity", 0}},
                                      {{"mass", 1e-6}},      {{"particles", 40}},
                                      {{"angle", 0}},        {{"length", 1e-3}}};
  const Scene scene = scene_of("rope");
  for (const Changes& changes : extremes) {
    INFO(changes.begin()->first << " = " << changes.begin()->second);
    for (const Method& method : scene.methods) {
      const auto rope =
          run_for(scene, setup_of(scene, method.name, changes), 30 * scene.dt);
      if (method.name != "distance_constraints") continue;
      for (const Metric& m : rope->metrics()) CHECK(std::isfinite(m.value));
    }
  }
}
