// Chapter 6's scenes of friction and tipping, as a program would drive them. Compiled
// for each precision.
#include <cmath>
#include <limits>

#include "chapters/06-impulses/scenes.hpp"
#include "common/physics/exact_sliding.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_06::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr double k_g = 9.81, k_60_hz = 1.0 / 60;

std::unique_ptr<Simulation> run_all(const std::string& name, const std::string& method,
                                    const Changes& changes = {}) {
  const Scene scene = scene_of(name);
  return run_for(scene, setup_of(scene, method, changes), scene.duration);
}

// Contacts that start without an impulse have all of it after a step: until then up to
// a step's share of friction is missing, or of what it should have done
double missing_speed(double friction) {
  return friction * k_g * k_60_hz;
}

}  // namespace

TEST_CASE("a block on a slope stays below the angle of friction, and slides above it") {
  for (const char* method : {"substeps", "sequential_impulses", "lcp"}) {
    for (const double share : {0.9, 1.1}) {
      INFO(method << ", " << share);
      const double mu = 0.4, angle = share * std::atan(mu);
      const auto block = run_all("ramp", method, {{"angle", angle}, {"friction", mu}});
      if (share < 1) {
        // It creeps by less than a micrometre in as long, and the rounding of what
        // holds it, each step anew
        CHECK(metric(*block, "fastest") <= 1e-6 / 1.8 + 64 * k_u * k_g * k_60_hz);
        CHECK(metric(*block, "way_error") <= missing_speed(mu) * k_60_hz);
      } else {
        // The speed at the end is off by what is missing at the start at most
        CHECK(metric(*block, "way_error_max") <= missing_speed(mu) * 1.8);
        CHECK(metric(*block, "way_down") > 0.5);
      }
    }
  }
}

TEST_CASE("a block slides down with gravity's pull less friction's") {
  for (const char* method : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(method);
    const auto block = run_all("ramp", method);

    // From two speeds a step apart, each rounded some dozen times; and what a corner
    // carries still changes by a hundred-thousandth of the weight
    const double tolerance = 2 * 16 * k_u * 2.3 / k_60_hz + 1e-5 * k_g;
    CHECK(std::abs(metric(*block, "acceleration")
                   - metric(*block, "acceleration_from_rest_exact"))
          <= tolerance);
  }
}

TEST_CASE("pushed askew, a block stops in line by the cone, and aside by the pyramid") {
  const Changes askew{{"angle", 0}, {"speed", 5}, {"direction", 0.5}};
  const glm::dvec2 v = 5.0 * glm::dvec2(std::cos(0.5), std::sin(0.5));
  const double allowed =
      missing_speed(0.4) * 5 / (0.4 * k_g);  // for as long as it slides
  for (const char* method : {"substeps", "sequential_impulses", "lcp"}) {
    INFO(method);
    const auto cone = run_all("ramp", method, askew);
    CHECK(metric(*cone, "way_error_max") <= allowed);

    Changes square = askew;
    square["use_pyramid"] = 1;
    const auto pyramid = run_all("ramp", method, square);
    const exact::Stop stop = exact::pyramid_stop(v, 0.4, k_g);
    CHECK(std::abs(metric(*pyramid, "way_down") - stop.x.x) <= allowed);
    CHECK(std::abs(metric(*pyramid, "way_across") - stop.x.y) <= allowed);
    CHECK(metric(*pyramid, "way_error") > 0.5);
  }
}

TEST_CASE("a sliding ball comes to roll when and as fast as it should") {
  for (const char* method : {"substeps", "sequential_impulses", "worst_first", "lcp"}) {
    for (const double topspin : {-40.0, 0.0, 60.0}) {
      INFO(method << ", " << topspin);
      const auto ball =
          run_all("slide-to-roll", method, {{"topspin", topspin}, {"friction", 0.5}});
      const double late =
          metric(*ball, "rolling_time") - metric(*ball, "rolling_time_exact");
      CHECK(late > -k_60_hz);
      CHECK(late < 2 * k_60_hz);

      // What sinks in has a shorter arm; 60 steps of 8 sweeps round a few m/s
      const double arm = metric(*ball, "penetration_max");
      const double omega = metric(*ball, "speed_exact") / 0.2;
      CHECK(metric(*ball, "velocity_error") <= arm * omega + 480 * 8 * k_u);
    }
  }
}

TEST_CASE("a rod falls at the rate that its energy says, the closer the shorter dt") {
  for (const double friction : {0.0, 0.6}) {
    for (const char* method : {"substeps", "sequential_impulses", "lcp"}) {
      INFO(method << ", " << friction);
      const Changes floor{{"friction", friction}};
      const auto coarse = run("rod", method, 1.0 / 240, 0.5, floor);
      const auto fine = run("rod", method, 1.0 / 960, 0.5, floor);
      CHECK(metric(*coarse, "rate_error_max") < 0.02);

      // First order at least: a quarter, and rounding of 480 steps in single
      CHECK(metric(*fine, "rate_error_max")
            <= 0.5 * metric(*coarse, "rate_error_max") + 480 * 8 * k_u);
      CHECK(metric(*fine, "compared_until") > 0.5);
    }
  }
}

TEST_CASE("a rod that slides on its end is pressed as Painlevé says, until it jams") {
  Changes sliding{{"tilt", std::atan(0.5)}, {"speed", 3}, {"friction", 1}};
  for (const char* method : {"worst_first", "sequential_impulses", "lcp"}) {
    INFO(method);

    // tan theta = 2: p = 1 + 3 (1 - 2 mu) / 5; the lean changes by 1e-5 in a step
    const auto slides = run("rod", method, 1e-4, 1e-4, sliding);
    CHECK(metric(*slides, "painleve_p") == Approx(0.4));
    CHECK(metric(*slides, "first_pressure_exact") == Approx(2.5));
    CHECK(metric(*slides, "first_pressure") == Approx(2.5).epsilon(0.01));

    // From friction 4/3 on no force serves: an impulse that does not vanish with dt
    sliding["friction"] = 2;
    const auto jams = run("rod", method, 1e-4, 1e-4, sliding);
    CHECK(metric(*jams, "painleve_p") < 0);
    CHECK(metric(*jams, "first_pressure") * 1e-4 * k_g > 0.5);
    sliding["friction"] = 1;
  }
}

TEST_CASE("a rocking block loses at each impact what its shape says") {
  for (const char* method : {"substeps", "sequential_impulses"}) {
    INFO(method);
    const auto error = [&](double dt) {
      const auto block = run("rocking-block", method, dt, 1);
      CHECK(std::abs(metric(*block, "first_impact")
                     - metric(*block, "first_impact_exact"))
            <= 2 * dt);
      return std::abs(metric(*block, "next_tilt") - metric(*block, "next_tilt_exact"));
    };

    // First order: a quarter, and rounding of 4000 steps in single
    CHECK(error(0.001) <= 0.5 * error(0.004) + 4000 * 8 * k_u);
  }
}
