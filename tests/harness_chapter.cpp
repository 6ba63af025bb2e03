// A tiny chapter for the tests of the harness: a ball that falls, a spring that blows
// up, scenes that get stuck, refuse or fail. Not physics to learn from: see chapter 1
// for that.
#include <cmath>
#include <stdexcept>

#include "common/chapter/scene.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"

using namespace timestep;

namespace {

/// One ball under an acceleration that depends on its place, along one axis.
template <typename Real>
class Ball1d : public Simulation {
 public:
  Ball1d(const Setup& setup, double position, double velocity)
      : chosen(setup),
        coordinate(static_cast<Real>(position)),
        rate(static_cast<Real>(velocity)) {}

  void step() override {
    const Real dt = static_cast<Real>(chosen.dt);
    const Real old_velocity = rate;
    rate += acceleration(coordinate) * dt;
    coordinate += (chosen.method == "late" ? old_velocity : rate) * dt;
    elapsed += chosen.dt;
  }

  void observe() override { path.push_back(place()); }

  std::vector<BodyState> bodies() const override {
    return {{.name = "ball", .position = place(), .velocity = along(rate)}};
  }

  std::vector<Metric> metrics() const override {
    return {
        {"position_error", "m", std::abs(static_cast<double>(coordinate) - exact())},
        {"speed", "m/s", std::abs(static_cast<double>(rate))}};
  }

  long long evaluations() const override { return std::llround(elapsed / chosen.dt); }
  long long body_count() const override { return 1; }

  void draw(DrawList& list) const override {
    const float side = static_cast<float>(chosen.lane);
    list.balls.push_back(
        {glm::vec3(place()) + glm::vec3(side, 0, 0), 0.3F, chosen.style.color});
    Polyline trail{
        .points = {}, .color = chosen.style.color, .dash = chosen.style.dash};
    for (const glm::dvec3& point : path) {
      trail.points.push_back(glm::vec3(point) + glm::vec3(side, 0, 0));
    }
    list.lines.push_back(trail);
  }

  void draw_reference(DrawList& list) const override {
    list.markers.push_back(
        {glm::vec3(along(static_cast<Real>(exact()))), reference_style(), 14});
  }

 protected:
  virtual Real acceleration(Real position) const = 0;
  virtual double exact() const = 0;
  virtual glm::dvec3 along(Real value) const { return {0, value, 0}; }
  glm::dvec3 place() const { return along(coordinate); }
  double parameter(const char* name) const { return chosen.parameters.at(name); }

  Setup chosen;
  double elapsed = 0;
  Real coordinate, rate;
  std::vector<glm::dvec3> path;
};

template <typename Real>
class Fall : public Ball1d<Real> {
 public:
  explicit Fall(const Setup& setup)
      : Ball1d<Real>(setup, setup.parameters.at("height"), 0) {}

  std::vector<BodyState> bodies() const override {
    std::vector<BodyState> bodies = Ball1d<Real>::bodies();
    const double count = this->parameter("spinners");
    for (int i = 0; i < static_cast<int>(count); ++i) {
      bodies.push_back(
          {.name = "spinner, \"" + std::to_string(i) + "\"",
           .orientation = glm::angleAxis(this->elapsed, glm::dvec3(0, 0, 1)),
           .angular_velocity = glm::dvec3(0, 0, 1)});
    }
    return bodies;
  }

 protected:
  Real acceleration(Real) const override {
    return static_cast<Real>(-this->parameter("gravity"));
  }
  double exact() const override {
    return this->parameter("height")
           - 0.5 * this->parameter("gravity") * this->elapsed * this->elapsed;
  }
};

template <typename Real>
class Spring : public Ball1d<Real> {
 public:
  explicit Spring(const Setup& setup) : Ball1d<Real>(setup, 1, 0) {}

 protected:
  Real acceleration(Real position) const override {
    return static_cast<Real>(-this->parameter("stiffness")) * position;
  }
  double exact() const override {
    return std::cos(std::sqrt(this->parameter("stiffness")) * this->elapsed);
  }
};

/// Gives up in the middle of a run, as no scene should.
class Fails : public Fall<double> {
 public:
  using Fall<double>::Fall;
  void step() override {
    if (elapsed > 0.1) throw std::runtime_error("the scene gave up");
    Fall<double>::step();
  }
};

/// Comes to a step that it cannot take.
class Stuck : public Fall<double> {
 public:
  using Fall<double>::Fall;
  void step() override {
    if (elapsed > 0.1) throw StepFailure("no way on");
    Fall<double>::step();
  }
};

const Parameter k_height{"height", "m", "where the ball starts", 2, 0, 100};
const Parameter k_gravity{"gravity", "m/s^2", "pull downwards", 9.81, 0, 30};
const Parameter k_spinners{"spinners", "", "bodies that turn", 1, 0, 100, true};
const Parameter k_stiffness{"stiffness", "1/s^2", "of the spring", 40, 1e-6, 1e6};

template <typename Simulated>
std::unique_ptr<Simulation> start(const Setup& setup) {
  return std::make_unique<Simulated>(setup);
}

/// Says what it was asked to do.
class Turned : public Fall<double> {
 public:
  using Fall<double>::Fall;
  std::vector<std::string> notices() const override { return {"the mesh is turned"}; }
};

std::unique_ptr<Simulation> start_with_mesh(const Setup& setup) {
  if (!setup.mesh.empty()) load_mesh(setup.mesh);
  return setup.fix_winding ? start<Turned>(setup) : start<Fall<double>>(setup);
}

std::unique_ptr<Simulation> refuse(const Setup&) {
  throw InputError("scene refuses: it never starts");
}

template <typename Real>
std::vector<Scene> scenes() {
  const std::vector<Method> methods{
      {"early", "moves with the new velocity", method_style(0)},
      {"late", "moves with the old velocity", method_style(1)}};
  const std::vector<Parameter> ball{k_height, k_gravity, k_spinners};
  const Scene fall{
      .name = "fall",
      .summary = "A ball falls; the other bodies turn.",
      .methods = methods,
      .default_methods = {"early"},
      .parameters = ball,
      .presets = {{"moon", "NASA fact sheet: 1.62 m/s^2", {{"gravity", 1.62}}}},
      .duration = 0.5,
      .chart_metric = "position_error",
      .start = start<Fall<Real>>};

  Scene spring = fall, mesh = fall, stuck = fall, fails = fall, refuses = fall;
  spring.name = "spring";
  spring.summary = "A spring; `late` gains energy, and either blows up at a long step.";
  spring.default_methods = {"early", "late"};
  spring.parameters = {k_stiffness};
  spring.presets.clear();
  spring.duration = 4;
  spring.chart_logarithmic = true;
  spring.start = start<Spring<Real>>;

  mesh.name = "mesh";
  mesh.takes_mesh = mesh.fixes_winding = true;
  mesh.start = start_with_mesh;
  stuck.name = "stuck";
  stuck.start = start<Stuck>;
  fails.name = "fails";
  fails.start = start<Fails>;
  refuses.name = "refuses";
  refuses.start = refuse;
  return {fall, spring, mesh, stuck, fails, refuses};
}

}  // namespace

int main(int argc, char** argv) {
  const Chapter chapter{.name = "harness-chapter",
                        .title = "A chapter for the tests",
                        .single_precision = scenes<float>(),
                        .double_precision = scenes<double>()};
  return run_chapter(chapter, argc, argv);
}
