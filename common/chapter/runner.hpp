/// @file
/// Runs one or several methods of a scene side by side, step for step.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/chapter/plan.hpp"

namespace timestep {

/// When and how a simulation failed: its numbers ceased to be numbers, or a step could
/// not be taken.
struct Failure {
  long long step = 0;  ///< the first step after which that was so
  double time = 0;     ///< [s]
  std::string what;    ///< "position of ball is nan"
};

/// One method on its way. `bodies` and `metrics` are those of the last sample.
struct Lane {
  const Setup* setup = nullptr;
  std::unique_ptr<Simulation> simulation{};
  long long steps = 0;
  double wall_seconds = 0;  ///< spent in step() alone
  std::vector<BodyState> bodies{};
  std::vector<Metric> metrics{};
  std::optional<Failure> failure{};
};

/// Somebody who wants to look at the run: `next(step)` is the first step at or after
/// `step` at which `see` shall be called.
struct Observer {
  std::function<long long(long long step)> next;
  std::function<void(long long step)> see;
};

/// Starts every method of the plan, which must outlive the lanes. Whatever a scene
/// throws passes through.
std::vector<Lane> start_lanes(const Plan& plan);

/// What the lanes have to say of their start, each line once.
std::vector<std::string> notices(std::span<const Lane> lanes);

/// The look that the run asks for: its first method's, or the scene's without one.
CameraPose usual_camera(const Plan& plan, std::span<const Lane> lanes);

/// Brings every lane that has not failed to `step`; one whose step fails stays there.
/// Throws Interrupted after Ctrl+C.
void advance_lanes(const Plan& plan, std::span<Lane> lanes, long long step);

/// Takes bodies and metrics of every lane. One with a number that is not finite fails:
/// at the first step after `last_good` after which that is so, found by running again.
void sample_lanes(const Plan& plan, std::span<Lane> lanes, long long last_good);

/// How many steps lie between two samples: at most 60 samples a simulated second.
long long sample_stride(double dt);

/// Runs all lanes to the plan's end. At the start, every `sample_stride` steps and at
/// the end it takes a sample. Observers see a step after its sample. `progress` gets
/// the share done now and then. Throws Interrupted after Ctrl+C.
void run_lanes(const Plan& plan, std::span<Lane> lanes,
               std::span<const Observer> observers,
               const std::function<void(double)>& progress);

}  // namespace timestep
