// The parts of the harness that need no program around them.
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "common/chapter/filmstrip.hpp"
#include "common/chapter/fixed_step.hpp"
#include "common/chapter/interpolate.hpp"
#include "common/chapter/metric_log.hpp"
#include "common/chapter/names.hpp"
#include "common/chapter/numbers.hpp"
#include "common/chapter/outputs.hpp"
#include "common/chapter/picture.hpp"
#include "common/chapter/results.hpp"
#include "common/chapter/session.hpp"
#include "common/chapter/tables.hpp"
#include "common/graphics/input_error.hpp"
#include "tests/catch.hpp"
#include "tests/graphics_paths.hpp"

using namespace timestep;

namespace fs = std::filesystem;

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// A simulation whose only number is given, and turns to NaN after some step; or that
/// refuses the step after it.
class Countdown : public Simulation {
 public:
  Countdown(int good_steps, bool refuses)
      : good_steps_(good_steps), refuses_(refuses) {}
  void step() override {
    if (refuses_ && steps_ == good_steps_) throw StepFailure("no way on");
    ++steps_;
  }
  std::vector<BodyState> bodies() const override {
    const double x = steps_ > good_steps_ ? k_nan : 0.1 * steps_;
    return {{.name = "a,b", .position = {x, -0.0, 1e-310}, .velocity = {1, 2, 3}}};
  }
  std::vector<Metric> metrics() const override { return {{"count", "", 1.0 * steps_}}; }
  long long evaluations() const override { return steps_; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override { list.title += "x"; }

 private:
  int good_steps_ = 0, steps_ = 0;
  bool refuses_ = false;
};

Chapter countdown_chapter(int good_steps) {
  const auto start = [=](const Setup& setup) {
    return std::make_unique<Countdown>(setup.method == "safe" ? 1 << 30 : good_steps,
                                       setup.method == "refusing");
  };
  const Scene scene{
      .name = "count",
      .summary = "",
      .methods = {{"safe", "", {}}, {"doomed", "", {}}, {"refusing", "", {}}},
      .default_methods = {"safe", "doomed"},
      .parameters = {{"n", "", "", 3, 0, 9, true}, {"x", "m", "", 0.1, 0, 1}},
      .dt = 0.001,
      .duration = 0.1,
      .start = start};
  return {"00-count", "Counting", {scene}, {scene}};
}

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("frames of exactly dt are exactly one step each") {
  for (const double dt : {1.0 / 60, 0.1, 1e-6, 0.3}) {
    FixedStep clock{.dt = dt};
    for (int frame = 0; frame < 100000; ++frame) REQUIRE(clock.advance(dt) == 1);
    CHECK(clock.accumulator == 0);
    CHECK(clock.dropped == 0);
  }
}

TEST_CASE("parts of a step add up without drift") {
  for (const int parts : {2, 3, 7, 10, 49}) {
    FixedStep clock{.dt = 1.0 / 60};
    int steps = 0;
    for (int frame = 0; frame < parts * 1000; ++frame) {
      steps += clock.advance(clock.dt / parts);
    }
    CHECK(steps == 1000);
  }
}

TEST_CASE("all frame time is simulated, waiting or dropped") {
  FixedStep clock{.dt = 0.01, .max_steps_per_frame = 4};
  double total = 0, simulated = 0;
  for (int frame = 0; frame < 1000; ++frame) {
    const double frame_time = frame % 100 == 0 ? 0.5 : 0.0173;
    total += frame_time;
    const int steps = clock.advance(frame_time);
    REQUIRE(steps <= 4);
    simulated += steps * clock.dt;
  }
  CHECK(std::abs(simulated + clock.accumulator + clock.dropped - total) < 1e-11);
  CHECK(clock.dropped > 4);
}

TEST_CASE("a frame time that is none does nothing") {
  FixedStep clock{.dt = 0.01, .max_steps_per_frame = 4};
  for (const double frame_time : {k_nan, k_infinity, -k_infinity, -1.0, 0.0}) {
    CHECK(clock.advance(frame_time) == 0);
  }
  CHECK(clock.advance(1e300) == 4);
  CHECK(clock.alpha() >= 0);
  CHECK(clock.alpha() <= 1);
  CHECK(FixedStep{.dt = 0}.advance(1) == 0);
  CHECK(FixedStep{.dt = k_nan}.advance(1) == 0);
}

TEST_CASE("alpha is the share of the next step that has passed") {
  FixedStep clock{.dt = 0.5};
  clock.advance(0.625);
  CHECK(clock.alpha() == 0.25);
}

TEST_CASE("the nearest names are found") {
  const std::vector<std::string> names{"projectile", "spring", "fountain",
                                       "frame-drops"};
  CHECK(edit_distance("spring", "sprign") == 1);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(nearest_names("sprin", names) == std::vector<std::string>{"spring"});
  CHECK(nearest_names("drops", names) == std::vector<std::string>{"frame-drops"});
  CHECK(nearest_names("zzzzzz", names).empty());
  CHECK(unknown_name("scene", "sprin", names)
        == "unknown scene \"sprin\"; did you mean spring?");
  CHECK(
      unknown_name("scene", "?", names)
      == "unknown scene \"?\"; choose from projectile, spring, fountain, frame-drops");
}

TEST_CASE("numbers are read strictly") {
  CHECK(parse_number("1e-3") == 1e-3);
  CHECK(parse_number("-2.5") == -2.5);
  CHECK(parse_number("1/60") == 1.0 / 60);
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "-inf", "1e999", "0x10", "1,5",
                           "1/0", "1/", "/2", "1/2/3", "abc", "1s"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text).has_value());
  }
  CHECK(parse_integer("30", 1, 240) == 30);
  for (const char* text : {"0", "241", "1.5", "", "1e2", "99999999999"}) {
    CHECK_FALSE(parse_integer(text, 1, 240).has_value());
  }
}

TEST_CASE("numbers as text read back to the same bits") {
  for (const double value :
       {0.1, 1.0 / 3, 1e-310, 1.7976931348623157e308, -0.0, 5e-324}) {
    CHECK(parse_number(exact_text(value)) == value);
  }
  CHECK(exact_text(k_nan) == "nan");
  CHECK(exact_text(-k_nan) == "nan");
  CHECK(exact_text(-k_infinity) == "-inf");
  CHECK(plain_text(1e6) == "1e+06");
  CHECK(plain_text(1.0 / 3) == "0.3333333333333333");
  CHECK(step_text(1.0 / 60) == "1/60 s");
  CHECK(step_text(0.01) == "0.01 s");
}

TEST_CASE("pictures are interpolated by position and shortest rotation") {
  DrawList before, after;
  before.balls = {{.center = {0, 0, 0}, .radius = 1}};
  after.balls = {{.center = {1, 2, 4}, .radius = 3}};
  before.shapes.emplace_back();
  after.shapes.emplace_back();
  const glm::quat quarter = glm::angleAxis(glm::radians(90.0F), glm::vec3(0, 1, 0));
  after.shapes[0].world_from_shape = 2.0F * glm::mat4_cast(quarter);
  after.shapes[0].world_from_shape[3] = {4, 0, 0, 1};

  const DrawList half = interpolate(before, after, 0.5F);
  CHECK(half.balls[0].center == glm::vec3(0.5F, 1, 2));
  CHECK(half.balls[0].radius == 2);
  const glm::mat4& m = half.shapes[0].world_from_shape;
  CHECK(m[3].x == 2);
  CHECK(std::abs(m[0].x - 1.5F * std::sqrt(0.5F)) < 1e-6F);
  CHECK(std::abs(m[0].z + 1.5F * std::sqrt(0.5F)) < 1e-6F);
  CHECK(interpolate(before, after, 0).balls[0].radius == 1);
  CHECK(interpolate(before, after, 1).balls[0].radius == 3);
}

TEST_CASE("lists of unequal length wait, growing lines grow") {
  DrawList before, after;
  before.balls.resize(2);
  after.balls.resize(3);
  before.lines = {{.points = {{0, 0, 0}, {1, 0, 0}}}};
  after.lines = {{.points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}};
  const DrawList half = interpolate(before, after, 0.5F);
  CHECK(half.balls.size() == 2);
  REQUIRE(half.lines[0].points.size() == 3);
  CHECK(half.lines[0].points[2].x == 2);
}

TEST_CASE("a flat or mirrored shape is interpolated without NaN") {
  const glm::mat4 flat{glm::vec4(1, 0, 0, 0), glm::vec4(0), glm::vec4(0, 0, 1, 0),
                       glm::vec4(0, 0, 0, 1)};
  const glm::mat4 middle = interpolate(flat, glm::mat4(1), 0.5F);
  CHECK(middle[1].y == 0.5F);
}

TEST_CASE("a plan has the steps that fit") {
  const Chapter chapter = countdown_chapter(10);
  CHECK(make_plan(chapter, {.dt = "1/60", .duration = "5"}).steps == 300);
  CHECK(make_plan(chapter, {.dt = "0.1", .duration = "0.3"}).steps == 3);
  CHECK(make_plan(chapter, {.dt = "0.3", .duration = "1"}).steps == 3);
  CHECK(make_plan(chapter, {.dt = "1e-6", .duration = "1"}).steps == 1000000);
  CHECK_THROWS_AS(make_plan(chapter, {.dt = "1e-12", .duration = "1"}), InputError);
  CHECK_THROWS_AS(make_plan(chapter, {.settings = {{"n", "1.5"}}}), InputError);
}

TEST_CASE("samples are 60 a second, and at least one a run") {
  CHECK(sample_stride(1.0 / 60) == 1);
  CHECK(sample_stride(1.0) == 1);
  CHECK(sample_stride(1e300) == 1);
  CHECK(sample_stride(1e-3) == 17);
  CHECK(sample_stride(1e-300) == 1000000000);
  CHECK(sample_stride(5e-324) == 1000000000);
}

TEST_CASE("a lane stops at the first step that is not finite") {
  for (const int good : {0, 1, 15, 16, 17, 18, 50, 98}) {
    const Chapter chapter = countdown_chapter(good);
    const Plan plan = make_plan(chapter, {});
    std::vector<Lane> lanes = start_lanes(plan);
    run_lanes(plan, lanes, {}, [](double) {});
    CHECK(lanes[0].steps == 100);
    CHECK_FALSE(lanes[0].failure.has_value());
    REQUIRE(lanes[1].failure.has_value());
    CHECK(lanes[1].failure->step == good + 1);
    CHECK(lanes[1].steps == good + 1);
    CHECK(lanes[1].failure->what == "position of a,b is not finite");
  }
}

TEST_CASE("results.json reads back to the same bits and names what is not finite") {
  const Chapter chapter = countdown_chapter(10);
  const Plan plan = make_plan(chapter, {});
  std::vector<Lane> lanes = start_lanes(plan);
  run_lanes(plan, lanes, {}, [](double) {});
  const auto json = nlohmann::json::parse(results_json(plan, lanes));

  CHECK(json["method"] == "safe,doomed");
  CHECK(json["parameters"]["n"] == 3);
  CHECK(json["parameters"]["x"].get<double>() == 0.1);
  CHECK(json["state"][0]["name"] == "safe/a,b");
  CHECK(json["state"][0]["position"][0].get<double>() == 0.1 * 100);
  CHECK(std::signbit(json["state"][0]["position"][1].get<double>()));
  CHECK(json["state"][0]["position"][2].get<double>() == 1e-310);
  CHECK(json["state"][1]["position"][0] == "nan");
  CHECK(json["failed"]["doomed/step"] == 11);
  CHECK(json["metrics"]["safe/count"]["value"] == 100);
  CHECK(json["cost"]["force_evaluations"] == 111);
  CHECK(json["cost"]["doomed/steps"] == 11);
}

TEST_CASE("a step that cannot be taken ends its own method, with its words") {
  const Chapter chapter = countdown_chapter(10);
  const Plan plan = make_plan(chapter, {.methods = {"refusing", "safe"}});
  std::vector<Lane> lanes = start_lanes(plan);
  run_lanes(plan, lanes, {}, [](double) {});

  REQUIRE(lanes[0].failure.has_value());
  CHECK(lanes[0].failure->step == 11);
  CHECK(lanes[0].failure->what == "no way on");
  CHECK(lanes[0].steps == 10);
  CHECK(lanes[0].metrics.at(0).value == 10);
  CHECK(lanes[1].steps == 100);
  CHECK_FALSE(lanes[1].failure.has_value());
  const auto json = nlohmann::json::parse(results_json(plan, lanes));
  CHECK(json["failed"].size() == 3);
  CHECK(json["failed"]["refusing/what"] == "no way on");
}

TEST_CASE("a picture says when a method failed, and how, whichever way it did") {
  const Chapter chapter = countdown_chapter(10);
  const Plan plan = make_plan(chapter, {.methods = {"safe", "doomed", "refusing"}});
  std::vector<Lane> lanes = start_lanes(plan);
  run_lanes(plan, lanes, {}, [](double) {});
  DrawList list;
  add_words(list, plan, lanes, plan.time(plan.steps));

  REQUIRE(list.legend.size() == 3);
  CHECK(list.legend[0].text == "safe");
  CHECK(list.legend[1].text == "doomed (failed at 0.011 s)");
  CHECK(list.legend[2].text == "refusing (failed at 0.011 s)");
  REQUIRE(list.caption.size() == 4);
  CHECK(list.caption[1] == "safe: count 100 ");
  CHECK(list.caption[2] == "doomed: position of a,b is not finite");
  CHECK(list.caption[3] == "refusing: no way on");
}

TEST_CASE("tables quote names and leave out what failed") {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  const Chapter chapter = countdown_chapter(0);
  const Plan plan = make_plan(chapter, {});
  std::vector<Lane> lanes = start_lanes(plan);
  Tables tables(folder / "t.csv", folder / "h.csv");
  sample_lanes(plan, lanes, 0);
  tables.add(0, lanes);
  advance_lanes(plan, lanes, 1);
  sample_lanes(plan, lanes, 0);
  tables.add(0.001, lanes);
  tables.finish();

  CHECK(content(folder / "h.csv") == "time,safe/count,doomed/count\n0,0,0\n0.001,1,\n");
  CHECK(content(folder / "t.csv")
        == "time,body,x,y,z,vx,vy,vz\n0,\"safe/a,b\",0,-0,1e-310,1,2,3\n"
           "0,\"doomed/a,b\",0,-0,1e-310,1,2,3\n"
           "0.001,\"safe/a,b\",0.1,-0,1e-310,1,2,3\n");
}

TEST_CASE("the log of metrics stays small and keeps the first sample") {
  const Chapter chapter = countdown_chapter(1 << 30);
  const Plan plan = make_plan(chapter, {.methods = {"safe"}});
  std::vector<Lane> lanes = start_lanes(plan);
  MetricLog log;
  for (int i = 0; i < 5000; ++i) {
    advance_lanes(plan, lanes, i);
    sample_lanes(plan, lanes, i);
    log.add(i, lanes);
  }
  const Chart chart = log.chart("count", false);
  REQUIRE(chart.series.size() == 1);
  CHECK(chart.series[0].points.size() <= 600);
  CHECK(chart.series[0].points.size() > 250);
  CHECK(chart.series[0].points.front() == glm::dvec2(0, 0));
  CHECK(log.chart("count", true).series[0].points.front().x > 0);
  CHECK(log.chart("none", false).series.empty());
}

TEST_CASE("a session runs in real time, step by step, to its end") {
  const Chapter chapter = countdown_chapter(30);
  Session session(chapter, {});
  REQUIRE(session.error().empty());
  session.advance(0.02, 1);
  CHECK(session.lanes()[0].steps == 20);
  session.step_once();
  CHECK(session.lanes()[0].steps == 21);
  CHECK(session.picture().title == "xx");
  session.advance(0.02, 0.5);
  CHECK(session.lanes()[1].failure->step == 31);
  for (int frame = 0; frame < 20; ++frame) session.advance(0.3, 1);
  CHECK(session.ended());
  CHECK(session.time() == 0.1);
  CHECK(session.dropped() > 0);
}

TEST_CASE("a session goes back step by step, to the same states") {
  const Chapter chapter = countdown_chapter(30);
  Session session(chapter, {});
  session.step_back();
  CHECK(session.lanes()[0].steps == 0);
  std::vector<double> seen;
  const auto value = [&] { return session.lanes()[0].metrics.at(0).value; };
  for (int step = 0; step < 20; ++step) {
    seen.push_back(value());
    session.step_once();
  }
  CHECK(seen[3] != seen[4]);
  for (int step = 19; step >= 0; --step) {
    session.step_back();
    CHECK(session.lanes()[0].steps == step);
    CHECK(value() == seen[static_cast<std::size_t>(step)]);
    CHECK(session.time() == session.plan().time(step));
  }
}

TEST_CASE("a session that cannot start says why and does nothing") {
  Chapter chapter = countdown_chapter(30);
  chapter.double_precision[0].start = [](const Setup&) -> std::unique_ptr<Simulation> {
    throw InputError("not today");
  };
  Session session(chapter, {});
  session.advance(1, 1);
  session.step_once();
  CHECK(session.error() == "not today");
  CHECK(session.lanes().empty());
  CHECK(Session(chapter, {.scene = "none"}).error().starts_with("unknown scene"));
}

TEST_CASE("outputs appear together or not at all") {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  {
    Outputs outputs;
    std::ofstream(outputs.stage("--out", folder / "new/sub/a.txt")) << "a";
  }
  CHECK(fs::is_empty(folder));

  Outputs outputs;
  std::ofstream(outputs.stage("--out", folder / "new/a.txt")) << "a";
  outputs.discard(outputs.stage("--out", folder / "new/b.txt"));
  CHECK_FALSE(fs::exists(folder / "new/a.txt"));
  outputs.publish();
  CHECK(content(folder / "new/a.txt") == "a");
  CHECK_FALSE(fs::exists(folder / "new/b.txt"));
  CHECK_THROWS_AS(outputs.stage("--out", folder / "new"), InputError);
  CHECK_THROWS_AS(outputs.stage("--out", folder / "new/a.txt/b"), InputError);
}

TEST_CASE("pictures are put side by side") {
  const std::vector<Image> images(2, Image{1, 1, {2, 4, 8, 255}});
  const Image strip = side_by_side(images);
  CHECK(strip.width == 6);
  CHECK(strip.rgba[0] == 2);
  CHECK(strip.rgba[4] == 255);
  CHECK(strip.rgba[20] == 2);
}
