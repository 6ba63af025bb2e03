/// @file
/// How long the rest of the study takes, and how to show it.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace timestep::study {

/// One thing to do: how long it is expected to take [s], and with what others it shares
/// how wrong that is.
struct Task {
  std::string group;
  double expected = 1;
  bool is_known = false;  ///< nothing is learnt of it from other groups
};

/// Guesses what is left from how the tasks so far of a group, or else of all, took
/// longer than expected.
class Estimate {
 public:
  explicit Estimate(std::vector<Task> tasks);

  /// The next task took so long [s].
  void finish(double seconds);

  double seconds_left() const;
  double seconds_spent() const { return all_.seconds; }
  std::size_t done() const { return done_; }
  std::size_t count() const { return tasks_.size(); }

 private:
  struct Pace {
    double expected = 0, seconds = 0;
  };

  std::vector<Task> tasks_;
  std::map<std::string, Pace> paces_;
  Pace all_;
  std::size_t done_ = 0;
};

/// "40 s", "3 min": as exact as an estimate deserves.
std::string duration_text(double seconds);

/// Shows an estimate on standard error: a bar on a terminal, else a line for each
/// tenth.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `what` is done now, such as "errors".
  void show(const Estimate& estimate, const std::string& what);

 private:
  std::chrono::steady_clock::time_point last_{};
  bool terminal_ = false, shown_ = false;
  int tenths_ = -1;  ///< that were told
};

}  // namespace timestep::study
