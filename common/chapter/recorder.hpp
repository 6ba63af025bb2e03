/// @file
/// Pictures of a run without a display: filmstrip, frames and movie.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/chapter/metric_log.hpp"
#include "common/chapter/movie.hpp"
#include "common/chapter/picture.hpp"
#include "common/chapter/runner.hpp"
#include "common/chapter/studio.hpp"

namespace timestep {

/// What to record, and under which (temporary) names.
struct Recording {
  glm::ivec2 size{1280, 720};  ///< of a frame [pixels]; the filmstrip's are smaller
  int fps = 30;                ///< of the movie [1/s]
  std::filesystem::path filmstrip;
  std::vector<std::filesystem::path> frames;  ///< evenly spaced over the run
  std::filesystem::path movie;                ///< empty: none
  std::filesystem::path ffmpeg;               ///< the program that makes the movie
};

/// A time at which a picture is due: `alpha` of the way from `step` to the next one.
struct Moment {
  enum class Use { filmstrip, frame, movie };
  long long step = 0;
  float alpha = 0;
  Use use = Use::movie;
  std::size_t index = 0;  ///< which of the filmstrip's or the frames
};

/// Every moment of a recording in the order of time. The filmstrip has four, the start
/// and the end included; the movie runs in real time if that takes 2 to 10 seconds,
/// else faster or slower.
std::vector<Moment> plan_moments(const Plan& plan, const Recording& recording);

/// Draws while the run goes on. Plan, lanes and log must outlive it.
class Recorder {
 public:
  /// Throws InputError if this machine cannot draw off-screen.
  Recorder(const Plan& plan, std::span<const Lane> lanes, const MetricLog& log,
           Recording recording);

  /// For `run_lanes`; refers to this recorder.
  Observer observer();

  /// Writes the filmstrip and ends the movie. What went wrong with the movie, if
  /// anything did; throws InputError if a picture cannot be written.
  std::optional<std::string> finish();

 private:
  long long next_step() const;
  void see(long long step);
  void shoot(const Moment& moment, DrawList list);
  Image develop_filmstrip();

  const Plan& plan_;
  std::span<const Lane> lanes_;
  const MetricLog& log_;
  CameraPose camera_;
  Recording recording_;
  std::vector<Moment> moments_;
  std::size_t due_ = 0;  // the first moment that was not drawn yet
  DrawList previous_;    // at previous_step_, to interpolate from
  long long previous_step_ = -1;
  std::vector<DrawList> filmstrip_;
  std::unique_ptr<Studio> studio_;
  std::unique_ptr<Movie> movie_;
};

}  // namespace timestep
