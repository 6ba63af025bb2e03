// Chapter 5's scenes, as a program would drive them. Compiled for each precision.
#include <cmath>
#include <limits>
#include <string>

#include "chapters/05-penetration/least_motion.hpp"
#include "chapters/05-penetration/scenes.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_05::scenes();
}

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr double k_dt = 1.0 / 60;

// Positions of up to 1 m that are rounded in each of 20 sweeps over 12 contacts or
// fewer, a few times each: if all of them went the same way
constexpr double k_rounded = 20 * 12 * 4 * k_u;

// What 20 sweeps leave of a depth that each takes a fifth out of
const double k_left = std::pow(0.8, 20);

std::unique_ptr<Simulation> steps(const std::string& scene, const std::string& method,
                                  int count, const Changes& changes = {}) {
  return run(scene, method, k_dt, count * k_dt, changes);
}

const Changes k_resting{
    {"boxes", 1}, {"overlap", 0.05}, {"slop", 0.01}, {"gravity", 0}};

}  // namespace

TEST_CASE("every scene runs with every method, stays finite, gives the same again") {
  for (const Scene& scene : tested_scenes()) {
    for (const Method& method : scene.methods) {
      INFO(scene.name << ", " << method.name);
      const auto before = scene.start(setup_of(scene, method.name))->metrics();
      const auto one = steps(scene.name, method.name, 10);
      const auto two = steps(scene.name, method.name, 10);
      const std::vector<Metric> after = one->metrics(), again = two->metrics();
      REQUIRE(after.size() == before.size());
      for (std::size_t i = 0; i < after.size(); ++i) {
        CHECK(after[i].name == before[i].name);
        CHECK(std::isfinite(after[i].value));
        CHECK(after[i].value == again[i].value);
      }
      CHECK(one->evaluations() > 0);
      DrawList list;
      one->draw_reference(list);
      one->draw(list);
      CHECK(!list.shapes.empty());
    }
  }
}

TEST_CASE("Formula 4 moves a feather and a ball by their shares") {
  for (const double ratio : {1.0, 1000.0, 1e6}) {
    INFO(ratio);
    const auto simulation = steps("feather-and-ball", "linear_projection", 1,
                                  {{"along", 0}, {"ratio", ratio}});
    const double depth = 0.04 * (1 - k_left);
    const double ball = depth / (1 + ratio), feather = depth * ratio / (1 + ratio);
    CHECK(std::abs(metric(*simulation, "ball_moved") - ball) <= k_rounded);
    CHECK(std::abs(metric(*simulation, "feather_moved") - feather) <= k_rounded);
  }
}

TEST_CASE("only a way out that ignores mass moves the common centre of mass") {
  for (const char* method :
       {"linear_projection", "worst_first", "split_impulse", "ngs"}) {
    INFO(method);
    CHECK(metric(*steps("feather-and-ball", method, 10), "centre_moved") <= k_rounded);
  }

  // The ball, which is nearly all of the mass, by half of the depth
  const auto equal = steps("feather-and-ball", "equal_shares", 10);
  const double shift = (1000.0 - 1) / 1001 * 0.04 / 2;
  CHECK(std::abs(metric(*equal, "centre_moved") - shift) <= 0.04 * k_left + k_rounded);
}

TEST_CASE("the least motion of a plank is the least of all that get it out") {
  const chapter_05::Plank plank{2, 0.1, 5, 1.7};
  const chapter_05::PlankPlace start{0.3, 0.5};
  const chapter_05::PlankPlace out = plank_out(plank, start);
  CHECK(std::abs(plank_depth(plank, out)) <= 1e-15);
  const auto motion = [&](const chapter_05::PlankPlace& place) {
    const double lift = place.height - start.height, turn = place.tilt - start.tilt;
    return plank.mass * lift * lift + plank.inertia * turn * turn;
  };
  for (int i = 0; i <= 1000; ++i) {
    const double tilt = 0.5 * i / 1000;
    const double height = plank_depth(plank, {0, tilt});  // just out
    CHECK(motion({height, tilt}) >= motion(out) - 1e-15);
  }
}

TEST_CASE("the least motion of a ball off a bar is the least of all that part them") {
  const chapter_05::BallOnBar pair{.ball_mass = 7,
                                   .radius = 0.3,
                                   .bar_mass = 0.5,
                                   .bar_inertia = 0.04,
                                   .half = 0.05,
                                   .along = 0.3,
                                   .above = 0.31};
  const chapter_05::Parting out = ball_off_bar(pair);
  CHECK(out.turn < 0);

  // For any other turn: what is then missing along the normal, shared by mass
  const auto motion = [&](double turn) {
    const double apart = pair.above * std::cos(turn) - pair.along * std::sin(turn);
    const double missing = pair.half + pair.radius - apart;
    const double reduced = 1 / (1 / pair.ball_mass + 1 / pair.bar_mass);
    return reduced * missing * missing + pair.bar_inertia * turn * turn;
  };
  for (int i = -1000; i <= 1000; ++i)
    CHECK(motion(out.turn) <= motion(out.turn + i * 1e-4) + 1e-16);
  CHECK(out.bar * pair.bar_mass == Approx(out.ball * pair.ball_mass).epsilon(1e-14));
}

TEST_CASE("a plank lifts its end; a way out that ignores turning lifts all of it") {
  const auto linear = steps("tilted-plank", "linear_projection", 10);
  const double lift = metric(*linear, "lift_exact");
  const double turn = metric(*linear, "turn_exact");
  CHECK(turn > 0.1);
  CHECK(std::abs(metric(*linear, "turn")) <= k_rounded);
  CHECK(std::abs(metric(*linear, "lift") - 0.1) <= 0.1 * k_left + k_rounded);

  // With its turn the lever changes by up to turn² / 2 of its length: what a push along
  // the first lever, or along many, is off by
  for (const char* method : {"split_impulse", "ngs"}) {
    INFO(method);
    const auto simulation = steps("tilted-plank", method, 30);
    CHECK(std::abs(metric(*simulation, "turn") - turn) <= turn * turn);
    CHECK(std::abs(metric(*simulation, "lift") - lift) <= turn * turn);
    CHECK(metric(*simulation, "penetration") <= 0.1 * std::pow(0.8, 30) * 1.1);
  }
}

TEST_CASE(
    "in a corner the box goes straight out, but pushes at single points turn it") {
  const auto linear = steps("corner", "linear_projection", 1);
  CHECK(metric(*linear, "position_error") <= 0.23 * k_left + k_rounded);
  CHECK(metric(*linear, "angle_error") <= k_rounded);

  // An iteration of its own for each contact, the deepest first
  const auto worst = steps("corner", "worst_first", 1);
  CHECK(metric(*worst, "angle_error") > 1e-6);
  CHECK(metric(*worst, "penetration") <= 1e-4 + k_rounded);
}

TEST_CASE("Baumgarte leaves beta (depth - slop) / dt behind, the others nothing") {
  for (const Method& method : scene_of("overlap-recovery").methods) {
    INFO(method.name);
    const auto simulation = steps("overlap-recovery", method.name, 1, k_resting);
    const double speed = metric(*simulation, "speed_max");
    if (method.name == "baumgarte")
      CHECK(std::abs(speed - 0.2 * 60 * 0.04) <= 60 * k_rounded);  // 0.48 m/s
    else
      CHECK(speed == 0);
  }
  const auto after = steps("overlap-recovery", "baumgarte", 1, k_resting);
  CHECK(std::abs(metric(*after, "penetration") - 0.042) <= k_rounded);
}

TEST_CASE("split impulses take a share out in each step, positions in each sweep") {
  const auto split = steps("overlap-recovery", "split_impulse", 3, k_resting);
  const double left = 0.01 + 0.04 * std::pow(0.8, 3);
  CHECK(std::abs(metric(*split, "penetration") - left) <= k_rounded);

  // Without turning, the four contacts of the face are the same one four times over
  Changes changes = k_resting;
  changes["iterations"] = 3;
  const auto linear = steps("overlap-recovery", "linear_projection", 1, changes);
  const double left_by_four = 0.01 + 0.04 * std::pow(0.8, 4 * 3);
  CHECK(std::abs(metric(*linear, "penetration") - left_by_four) <= k_rounded);
  CHECK(linear->evaluations() == 3 * 4);
}

TEST_CASE("a smaller step makes Baumgarte's speed larger") {
  const auto speed_at = [&](double dt) {
    return metric(*run("overlap-recovery", "baumgarte", dt, dt, k_resting),
                  "speed_max");
  };
  CHECK(std::abs(speed_at(1.0 / 240) - 4 * speed_at(1.0 / 60)) <= 240 * k_rounded);
}

TEST_CASE("a pile comes out of itself and stands, or pops") {
  for (const char* method : {"linear_projection", "worst_first", "split_impulse"}) {
    INFO(method);
    const auto simulation = steps("overlap-recovery", method, 60);
    CHECK(metric(*simulation, "standing") == 10);

    // What falls in a step, and the 200 sweeps have not stopped yet: a tenth of g dt
    CHECK(metric(*simulation, "speed_max") <= 0.1);
    CHECK(metric(*simulation, "penetration") <= 2e-3);
  }
  const auto popped = steps("overlap-recovery", "baumgarte", 30);
  CHECK(metric(*popped, "speed_max") > 8);
  CHECK(metric(*popped, "hop_max") > 2);
  CHECK(metric(*popped, "kinetic_energy_max") > metric(*popped, "energy_needed"));
}
