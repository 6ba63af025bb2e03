/// @file
/// What a chapter tells the harness: its scenes as data, and a running simulation as a
/// small interface. Numbers cross this border as double, whatever the precision inside.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "common/graphics/draw_list.hpp"

namespace timestep {

/// A number of a scene that the user may change with `--set NAME=VALUE`.
struct Parameter {
  std::string name, unit, help;
  double value = 0;                 ///< the default
  double minimum = 0, maximum = 0;  ///< valid range, both ends included
  bool integer = false;
};

/// Values from the real world for some of a scene's parameters: `--preset NAME`.
struct Preset {
  std::string name, source;  ///< source: where the constants come from
  std::map<std::string, double> values;
};

/// A method that a scene offers, and how it looks in pictures and plots.
struct Method {
  std::string name, summary;
  Style style;
};

/// What to simulate: one method, every parameter's value, the step.
struct Setup {
  std::string method;
  Style style;            ///< of that method
  std::size_t lane = 0;   ///< place among the methods that run side by side
  std::size_t lanes = 1;  ///< how many there are
  double dt = 0;          ///< fixed time step [s]
  double duration = 0;    ///< simulated time that is planned [s]
  std::map<std::string, double> parameters;  ///< every parameter of the scene
  std::filesystem::path mesh;                ///< the user's mesh; empty if none
  bool fix_winding = false;                  ///< turn it if it is inside out
};

/// One body's state, as it is written to files. Metres, metres a second, radians a
/// second, world frame; orientation world from body (w, x, y, z).
struct BodyState {
  std::string name;
  glm::dvec3 position{0}, velocity{0};
  std::optional<glm::dquat> orientation{};
  std::optional<glm::dvec3> angular_velocity{};
};

/// A measured number. The scene's first metric is its headline.
struct Metric {
  std::string name, unit;
  double value = 0;
};

/// Thrown by a step that cannot be taken: the run of that method ends there, with these
/// words.
struct StepFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A simulation in progress: it advances by one fixed step at a time, and can be asked
/// at any moment where things are, how wrong they are and how they look.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// What the user should know of the start, such as what was mended: a line each.
  virtual std::vector<std::string> notices() const { return {}; }

  /// Advances by `setup.dt`. This alone is timed. Throws StepFailure.
  virtual void step() = 0;

  /// Called at the start and after every step, outside of the timing: keeps track of
  /// what the metrics and the picture need (the largest error so far, a trail).
  virtual void observe() {}

  /// Every body, in a fixed order.
  virtual std::vector<BodyState> bodies() const = 0;

  /// The same names in the same order at every call.
  virtual std::vector<Metric> metrics() const = 0;

  /// Force evaluations or contacts solved since the start: exact, portable cost.
  virtual long long evaluations() const = 0;

  /// Bodies for which `evaluations` and time are counted.
  virtual long long body_count() const = 0;

  /// Adds what this method does to the picture, in the method's style. Lines that it
  /// adds to the caption stand below the harness's own.
  virtual void draw(DrawList& list) const = 0;

  /// The look that shows everything, if this run needs another one than the scene's.
  virtual CameraPose camera(const CameraPose& usual) const { return usual; }

  /// Adds what is the same for every method: the exact path, the ground, the props.
  virtual void draw_reference(DrawList&) const {}
};

/// A scene: everything that `--list` prints, and how to start it.
struct Scene {
  std::string name, summary;
  std::vector<Method> methods;
  std::vector<std::string> default_methods;  ///< drawn over each other if several
  std::vector<Parameter> parameters;
  std::vector<Preset> presets{};
  bool takes_mesh = false;     ///< `--mesh FILE` is understood
  bool fixes_winding = false;  ///< and so is `--fix-winding`: the mesh is a solid
  double dt = 1.0 / 60.0;      ///< default step [s]
  double duration = 5;         ///< default simulated time [s]
  CameraPose camera{};
  std::string chart_metric{};  ///< the metric drawn over time; none if empty
  bool chart_logarithmic = false;
  std::function<std::unique_ptr<Simulation>(const Setup&)> start;
};

/// What a chapter does with a file instead of simulating: `--OPTION FILE`, which goes
/// with `--method`, `--precision`, `--results` and `--out` alone.
struct FileJob {
  /// What to write as results.json. Throws InputError, in one line that names the file,
  /// for what is wrong with it.
  using Run = std::function<std::string(const std::filesystem::path& file,
                                        const std::string& method)>;

  std::string option, summary;  ///< the option as it is typed, without the dashes
  std::vector<Method> methods;  ///< the first is the default
  Run single_precision, double_precision;
};

/// A chapter: its scenes twice, from the same sources compiled for each precision. The
/// first scene is the default.
struct Chapter {
  std::string name;   ///< as the folder: "01-particles"
  std::string title;  ///< as the heading: "Particles and Euler"
  std::vector<Scene> single_precision, double_precision;
  std::vector<FileJob> file_jobs{};
};

/// Runs a chapter's executable: reads the options, then opens a window, renders
/// off-screen or only computes. Returns the exit code: 0, or 2 after one line on
/// standard error that says what was wrong with the input.
int run_chapter(const Chapter& chapter, int argc, const char* const* argv);

}  // namespace timestep
