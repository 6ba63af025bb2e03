// Model only what a scene requires: what is missing without each ingredient, by closed
// forms where there are.
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <nlohmann/json.hpp>

#include "common/physics/exact.hpp"
#include "common/physics/exact_bounce.hpp"
#include "common/physics/exact_cue_ball.hpp"
#include "study/ingredients/ingredients.hpp"
#include "tests/catch.hpp"

using namespace timestep;
using study::Comparison;
using study::error_of;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;
constexpr double k_g = 9.81;

struct Errors {
  double with, without;
};

Comparison find(const std::string& ingredient, bool matters) {
  for (const Comparison& each : study::ingredients())
    if (each.ingredient == ingredient && each.matters == matters) return each;
  throw std::out_of_range(ingredient);
}

Errors errors_of(const std::string& ingredient, bool matters) {
  const Comparison each = find(ingredient, matters);
  return {error_of(each, each.with), error_of(each, each.without)};
}

// [m] Between free fall and flight in air, of a ball of 40 mm with C_d = 0.47
double way_lost(double mass, const exact::Motion& start, double t) {
  const glm::dvec3 g(0, -k_g, 0);
  const double k = 1.2 * 0.47 * std::numbers::pi * 4e-4 / 2 / mass;
  return glm::distance(exact::constant_acceleration(start, g, t).x,
                       exact::quadratic_drag(start, g, k, t).x);
}

}  // namespace

TEST_CASE("every ingredient has a scene that requires it and one that does not") {
  std::map<std::string, std::set<bool>> found;
  for (const Comparison& each : study::ingredients())
    CHECK(found[each.ingredient].insert(each.matters).second);
  CHECK(found.size() == 12);
  for (const auto& [ingredient, scenes] : found) {
    INFO(ingredient);
    CHECK(scenes.size() == 2);
  }
}

TEST_CASE("where it matters the error without it is 3 times that with it, or more") {
  for (const Comparison& each : study::ingredients()) {
    if (each.ingredient == "restitution threshold") continue;  // bounces end anyway
    INFO(each.ingredient << ": " << each.scene);
    const double with = error_of(each, each.with);
    const double without = error_of(each, each.without);
    if (each.matters) CHECK(without > 3 * with);

    // Elsewhere, as seen by eye: within 4 mm in 1 s, or 4 mrad
    if (!each.matters) CHECK(std::max(with, without) < 4e-3);
  }
}

TEST_CASE("the same bits each time") {
  for (const Comparison& each : study::ingredients()) {
    INFO(each.ingredient << ": " << each.scene);
    CHECK(error_of(each, each.without) == error_of(each, each.without));
  }
  const Comparison drag = find("drag", true);
  CHECK(study::row_of(drag, 0).dump() == study::row_of(drag, 0).dump());
}

TEST_CASE("without drag a ball lands too far, by the difference of closed forms") {
  // RK4 is exact in free fall, to the rounding of 60 steps over 10 m
  const double v = 10 / std::numbers::sqrt2;
  CHECK(errors_of("drag", true).without
        == Approx(way_lost(0.0027, {{0, 0, 0}, {v, v, 0}}, 1)).margin(600 * k_u));
  CHECK(errors_of("drag", false).without
        == Approx(way_lost(0.263, {{0, 1, 0}, {0, 0, 0}}, 0.45)).margin(600 * k_u));

  // With it: (k v dt)^4 of the way, k = 0.13 / m, v = 10 m/s, over 10 m
  CHECK(errors_of("drag", true).with < 10 * std::pow(1.3 / 60, 4));
}

TEST_CASE("without rotation a ball slides to a stop that should roll on") {
  // mu g until it stops, as a block; the step in which it does is v dt long at most,
  // where v = mu g dt is left
  const exact::Ball ball{1, 0.1, 0.4, 0.2, k_g};
  const exact::BallMotion start{glm::dvec3(0), {2, 0, 0}, glm::dvec3(0)};
  const double rolled = exact::slide_then_roll(ball, start, 2).x.x;
  const double slid = 2 * 2 / (2 * 0.2 * k_g);
  CHECK(errors_of("rotation", true).without
        == Approx(rolled - slid).margin(0.2 * k_g / 3600));
  const Errors bar = errors_of("rotation", false);
  CHECK(bar.with == bar.without);
}

TEST_CASE(
    "a sphere's inertia turns a struck bar too fast, by J a t (1 / I_s - 1 / I)") {
  // A bar of 1 m and 0.1 m: moments (0.02, 1.01, 1.01) / 12
  const double moment = 1.01 / 12, mean = 2.04 / 36, turned = 0.1 * 0.5;
  const Errors bar = errors_of("inertia tensor", true);
  CHECK(bar.without
        == Approx(turned * (moment - mean) / (moment * mean)).epsilon(1e-13));
  CHECK(bar.with < 60 * 4 * k_u);
  CHECK(errors_of("inertia tensor", false).without < 60 * 4 * k_u);
}

TEST_CASE("the gyroscopic term is nothing to a die, and turns a book over") {
  CHECK(errors_of("gyroscopic term", false).without < 120 * 4 * k_u);

  // The book's axis has turned over; with the term, by a second-order method at 60 Hz
  const Errors book = errors_of("gyroscopic term", true);
  CHECK(book.without > 1);
  CHECK(book.with < 0.02);
}

TEST_CASE("without friction a block slides that should rest") {
  // Free fall along the slope is exact; with friction its contact's spring gives way
  CHECK(errors_of("friction", true).without
        == Approx(k_g / 2 * std::sin(0.3)).epsilon(1e-9));
  CHECK(errors_of("friction", true).with < 1e-4);
  const Errors ball = errors_of("friction", false);
  CHECK(ball.with == ball.without);
}

TEST_CASE("without rolling friction a ball rolls on that should stop") {
  // v² r (1 + k) / (2 rho g) of 4 m. Its weight presses the ball 0.11 mm into the soft
  // ground, by 1.1e-3 of its radius, which takes k / (1 + k) of that of its speed
  const double stop = 0.1 * 1.4 / (2 * 0.005 * k_g);
  const double lost = 4 * 1.1e-3 * 0.4 / 1.4;
  CHECK(errors_of("rolling friction", true).without == Approx(4 - stop).margin(lost));
  CHECK(errors_of("rolling friction", true).with < 1e-3);
}

TEST_CASE("a threshold brings a bouncing box to rest sooner, and keeps fast bounces") {
  const Errors boxes = errors_of("restitution threshold", true);
  CHECK(boxes.with < boxes.without / 2);
  const Errors ball = errors_of("restitution threshold", false);
  CHECK(ball.with == ball.without);
}

TEST_CASE("on one point a column falls, and without a warm start") {
  // A fall of the top takes it half a box away or more
  for (const char* ingredient : {"four-point manifold", "warm start"}) {
    INFO(ingredient);
    CHECK(errors_of(ingredient, true).without > 0.5);
    CHECK(errors_of(ingredient, true).with < 0.05);
  }
  const Errors ball = errors_of("four-point manifold", false);
  CHECK(ball.with == ball.without);
}

TEST_CASE("in single precision a step far away is a multiple of 1/16 m") {
  // x = 10^6 m needs 20 bits of 24; each of 60 steps of v dt is rounded to 1/16 m
  const double way = 10 / std::numbers::sqrt2, each = way / 60;
  const double rounded = std::round(each * 16) / 16;
  const Errors far = errors_of("double", true);
  CHECK(far.without == Approx(60 * rounded - way).margin(1e-4));
  CHECK(far.with <= 60 * 0x1p-34);
}

TEST_CASE("EPA finds the depth of boxes that the axes find") {
  // Depths below 0.5 m of boxes below 1 m
  CHECK(errors_of("EPA", true).with < 64 * k_u);
  CHECK(errors_of("EPA", true).without > 0.05);
  const Errors balls = errors_of("EPA", false);
  CHECK(std::max(balls.with, balls.without) < 64 * k_u);
}

TEST_CASE("costs are positive, and missing where none were asked for") {
  const study::Price price = study::price_of(find("EPA", true), 3);
  CHECK(price.with > 0);
  CHECK(price.without > 0);
  CHECK(price.spread >= 0);
  CHECK(study::row_of(find("EPA", true), 1).at("ns_with") > 0);
  CHECK_FALSE(study::row_of(find("EPA", true), 0).contains("ns_with"));
}
