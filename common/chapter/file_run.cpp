#include "common/chapter/file_run.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/chapter/numbers.hpp"
#include "common/chapter/outputs.hpp"
#include "common/chapter/recorder.hpp"
#include "common/chapter/results.hpp"
#include "common/chapter/results_file.hpp"
#include "common/chapter/tables.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

namespace fs = std::filesystem;

/// Where each file of a run is written until all are complete; empty if not wanted.
struct Files {
  fs::path results, trajectory, history;
  Recording recording;
};

void stage_pictures(Outputs& outputs, const fs::path& out, const Options& options,
                    Recording& recording) {
  recording.size = options.size;
  recording.fps = options.fps;
  recording.filmstrip = outputs.stage("--out", out / "filmstrip.png");
  for (int i = 0; i < options.frames.value_or(0); ++i) {
    const std::string file = fmt::format("frame-{:04}.png", i);
    recording.frames.push_back(outputs.stage("--out", out / "frames" / file));
  }
  const std::optional<fs::path> ffmpeg = find_program("ffmpeg");
  if (!options.movie || !ffmpeg) return;
  recording.ffmpeg = *ffmpeg;
  recording.movie = outputs.stage("--out", out / "movie.mp4");
}

Files stage_files(Outputs& outputs, const Plan& plan, const Options& options,
                  bool pictures) {
  const fs::path out = output_folder(*plan.chapter, options);
  Files files;
  if (pictures) stage_pictures(outputs, out, options, files.recording);
  if (pictures || options.out) {
    files.trajectory = outputs.stage("--out", out / "trajectory.csv");
    files.history = outputs.stage("--out", out / "history.csv");
  }
  files.results = stage_results(outputs, *plan.chapter, options);
  return files;
}

void report(const Plan& plan, std::span<const Lane> lanes, const Options& options) {
  for (const Lane& lane : lanes) {
    if (!lane.failure) continue;
    print_note(plan.chapter->name,
               fmt::format("{} failed at step {} (t = {} s): {}", lane.setup->method,
                           lane.failure->step, short_text(lane.failure->time),
                           lane.failure->what));
  }
  if (options.results == "-") return;

  std::string text =
      fmt::format("{}, {} steps of {} in {} precision\n", plan.scene->name, plan.steps,
                  step_text(plan.dt), name(plan.precision));
  for (const Lane& lane : lanes) {
    for (const Metric& metric : lane.metrics) {
      text += fmt::format("  {} {} = {} {}\n", lane.setup->method, metric.name,
                          short_text(metric.value), metric.unit);
    }
  }
  print_out(text);
}

/// Takes every sample into the log and, if they are written, the tables.
Observer sampler(const Plan& plan, std::span<const Lane> lanes, MetricLog& log,
                 Tables* tables) {
  const long long stride = sample_stride(plan.dt);
  return {.next =
              [&plan, stride](long long step) {
                return std::min((step + stride - 1) / stride * stride, plan.steps);
              },
          .see =
              [&plan, &log, lanes, tables](long long step) {
                log.add(plan.time(step), lanes);
                if (tables != nullptr) tables->add(plan.time(step), lanes);
              }};
}

/// Runs all lanes under the eyes of the log, the tables and the recorder. What went
/// wrong with the movie, if anything did.
std::optional<std::string> run_observed(const Plan& plan, std::span<Lane> lanes,
                                        const Files& files, const std::string& note) {
  MetricLog log;
  std::optional<Tables> tables;
  std::optional<Recorder> recorder;
  if (!files.history.empty()) tables.emplace(files.trajectory, files.history);
  std::vector<Observer> observers{
      sampler(plan, lanes, log, tables ? &*tables : nullptr)};
  if (!files.recording.filmstrip.empty()) {
    recorder.emplace(plan, lanes, log, files.recording);
    observers.push_back(recorder->observer());
  }

  if (!note.empty()) print_note(plan.chapter->name, note);
  Progress progress;
  run_lanes(plan, lanes, observers, [&](double share) { progress.show(share); });
  if (tables) tables->finish();
  return recorder ? recorder->finish() : std::nullopt;
}

}  // namespace

void run_to_files(const Plan& plan, const Options& options, bool pictures,
                  const std::string& note) {
  note_interrupts();
  std::vector<Lane> lanes = start_lanes(plan);
  for (const std::string& line : notices(lanes)) print_note(plan.chapter->name, line);
  Outputs outputs;
  const Files files = stage_files(outputs, plan, options, pictures);

  std::optional<std::string> trouble = run_observed(plan, lanes, files, note);
  if (trouble) outputs.discard(files.recording.movie);
  const bool no_ffmpeg = pictures && options.movie && files.recording.movie.empty();
  if (no_ffmpeg) trouble = "there is no ffmpeg in PATH";
  if (trouble) print_note(plan.chapter->name, "movie.mp4 is skipped: " + *trouble);

  write_results(files.results, options, results_json(plan, lanes));
  if (options.frames)
    remove_numbered_frames(output_folder(*plan.chapter, options) / "frames");
  outputs.publish();
  report(plan, lanes, options);
}

}  // namespace timestep
