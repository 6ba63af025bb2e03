/// @file
/// A run that goes on in real time: the fixed-step loop, whatever shows it.
#pragma once

#include <string>
#include <vector>

#include "common/chapter/fixed_step.hpp"
#include "common/chapter/metric_log.hpp"
#include "common/chapter/plan.hpp"
#include "common/chapter/runner.hpp"

namespace timestep {

/// One run in progress, restarted whenever the user changes anything. Stays where it
/// is.
class Session {
 public:
  /// Starts what was chosen. If that is refused, `error()` says why and nothing runs.
  Session(const Chapter& chapter, const Choice& choice);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Simulates what `frame_time` seconds of real time ask for at this speed, at most a
  /// tenth of a second's worth in a frame.
  void advance(double frame_time, double speed);

  /// Does one step.
  void step_once();

  /// Goes back by one step: starts again and does all others, which gives the same.
  void step_back();

  /// The scene as it is between the last two steps.
  DrawList picture() const;

  const std::string& error() const { return error_; }
  const Plan& plan() const { return plan_; }
  std::vector<Lane>& lanes() { return lanes_; }
  const MetricLog& log() const { return log_; }
  double time() const { return plan_.time(step_); }
  double dropped() const { return clock_.dropped; }
  bool ended() const { return step_ >= plan_.steps; }

 private:
  void begin();
  void advance_to(long long step);
  void take_sample();

  Plan plan_;
  std::vector<Lane> lanes_;
  MetricLog log_;
  FixedStep clock_;
  DrawList previous_, current_;
  long long step_ = 0;
  std::string error_;
};

}  // namespace timestep
