// Chapter 7's scenes: what the earlier chapters' say, with the choices' settings.
// Compiled for each precision.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/02-verlet/scenes.hpp"
#include "chapters/06-impulses/scenes.hpp"
#include "chapters/07-trade/scenes.hpp"
#include "chapters/07-trade/trade_run.hpp"
#include "common/physics/real.hpp"
#include "tests/catch.hpp"
#include "tests/scene_run.hpp"

using namespace timestep;
using namespace timestep::chapter_07;

std::vector<Scene> timestep::tested_scenes() {
  return chapter_07::scenes();
}

namespace {

// The earlier scene itself, as a reader of the table would start it
std::unique_ptr<Simulation> earlier_run(const Trade& trade, const Option& option,
                                        int frames) {
  const bool is_sixth = trade.chapter == "06-impulses";
  const std::vector<Scene> all = is_sixth ? chapter_06::scenes() : chapter_02::scenes();
  const Scene& scene =
      *std::ranges::find(all, trade.earlier, [](const Scene& s) { return s.name; });

  Changes changes = trade.settings;
  changes.insert(option.settings.begin(), option.settings.end());
  Setup setup = setup_of(scene, option.method, changes);
  setup.dt = trade.frame / option.steps_per_frame;
  auto simulation = scene.start(setup);
  simulation->observe();
  for (int i = 0; i < frames; ++i) {
    for (int k = 0; k < option.steps_per_frame; ++k) simulation->step();
    simulation->observe();
  }
  return simulation;
}

void check_same_bits(const Simulation& yours, const Simulation& theirs) {
  const std::vector<BodyState> a = yours.bodies(), b = theirs.bodies();
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].name == b[i].name);
    CHECK(a[i].position == b[i].position);
    CHECK(a[i].velocity == b[i].velocity);
  }
  for (const Metric& m : theirs.metrics()) {
    INFO(m.name);
    CHECK(metric(yours, m.name) == m.value);
  }
  CHECK(yours.evaluations() == theirs.evaluations());
  CHECK(yours.body_count() == theirs.body_count());
}

}  // namespace

TEST_CASE("each choice is the earlier chapter's scene, bit for bit") {
  constexpr int k_frames = 30;
  for (const Trade& trade : trades()) {
    for (const Option& option : trade.options) {
      INFO(trade.name << ", " << option.name);
      const auto yours =
          run(trade.name, option.name, trade.frame, k_frames * trade.frame);
      check_same_bits(*yours, *earlier_run(trade, option, k_frames));
    }
  }
}

TEST_CASE("steps in a frame are shorter by as many") {
  // Were the frame's steps as long as the frame, time would run so many times faster
  const Scene orbit = scene_of("orbit");
  const auto costly = run_for(orbit, setup_of(orbit, "costly"), orbit.dt);
  const auto cheap = run_for(orbit, setup_of(orbit, "too_cheap"), orbit.dt);
  CHECK(metric(*costly, "orbits") == Approx(metric(*cheap, "orbits")));
  CHECK(metric(*costly, "steps_per_orbit")
        == Approx(metric(*costly, "steps_per_frame")
                  * metric(*cheap, "steps_per_orbit")));
}

TEST_CASE("what is too cheap fails its wish, the others meet it") {
  for (const Trade& trade : trades()) {
    for (const Option& option : trade.options) {
      INFO(trade.name << ", " << option.name);
      const auto simulation = run(trade.name, option.name, trade.frame, trade.duration);
      const double share = metric(*simulation, "error_over_limit");
      CHECK((share < 1) == (option.name != "too_cheap"));

      // The headline is the worst of the wishes
      double worst = 0;
      for (const Wish& wish : trade.wishes)
        worst =
            std::max(worst, std::abs(metric(*simulation, wish.metric)) / wish.limit);
      CHECK(share == worst);
    }
  }
}

TEST_CASE("who is better looks more often") {
  for (const Trade& trade : trades()) {
    INFO(trade.name);
    long long before = 0;
    for (const Option& option : trade.options) {
      const auto simulation = run(trade.name, option.name, trade.frame, 1);
      CHECK(simulation->evaluations() > before);
      before = simulation->evaluations();
    }
  }
}

TEST_CASE("the user's parameters reach the earlier scene") {
  const auto blocks = run("falling-blocks", "good_enough", 1.0 / 60, 0.1, {{"n", 3}});
  CHECK(blocks->body_count() == 3);
  const auto rope = run("stiff-rope", "costly", 1.0 / 60, 0.1, {{"particles", 5}});
  CHECK(rope->bodies().size() == 5);
  const auto orbit = run("orbit", "good_enough", 1.0 / 60, 0, {{"eccentricity", 0.25}});
  CHECK(metric(*orbit, "eccentricity") == Approx(0.25));
}

TEST_CASE("the table's settings are in the range of the earlier scene's parameters") {
  for (const Trade& trade : trades()) {
    const Scene earlier = earlier_scene(trade);
    for (const Option& option : trade.options) {
      CHECK(option.steps_per_frame >= 1);
      const Setup setup =
          earlier_setup(trade, earlier, setup_of(scene_of(trade.name), option.name));
      for (const Parameter& p : earlier.parameters) {
        INFO(trade.name << ", " << option.name << ", " << p.name);
        CHECK(setup.parameters.at(p.name) >= p.minimum);
        CHECK(setup.parameters.at(p.name) <= p.maximum);
      }
    }
    // What is offered here is a parameter there
    CHECK(scene_of(trade.name).parameters.size() == trade.parameters.size());
  }
}

TEST_CASE("a table that names what is not there is refused") {
  Trade wrong = trades().front();
  wrong.earlier = "stacks";
  CHECK_THROWS_AS(earlier_scene(wrong), std::logic_error);
  wrong = trades().front();
  wrong.chapter = "08-none";
  CHECK_THROWS_AS(earlier_scene(wrong), std::logic_error);

  const Scene scene = scene_of("orbit");
  CHECK_THROWS_AS(scene.start(setup_of(scene, "cheapest")), std::logic_error);
}
