#include "common/chapter/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "common/chapter/filmstrip.hpp"
#include "common/chapter/interpolate.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/chapter/numbers.hpp"

namespace timestep {
namespace {

constexpr std::size_t k_filmstrip_length = 4;

/// The step at place `i` of `count` that are evenly spaced over the run.
long long even_step(long long steps, std::size_t i, std::size_t count) {
  if (count == 1) return steps;
  const double share = static_cast<double>(i) / static_cast<double>(count - 1);
  return std::llround(share * static_cast<double>(steps));
}

/// `count` whole steps, evenly spaced over the run with both ends.
void add_even_steps(std::vector<Moment>& moments, long long steps, std::size_t count,
                    Moment::Use use) {
  for (std::size_t i = 0; i < count; ++i) {
    moments.push_back({.step = even_step(steps, i, count), .use = use, .index = i});
  }
}

/// How long the movie of a run of `seconds` lasts [s].
double movie_length(double seconds) {
  return std::clamp(seconds, 2.0, 10.0);
}

void add_movie(std::vector<Moment>& moments, const Plan& plan, int fps) {
  constexpr double k_whole = 1e-6;  // of a step: no need to interpolate
  const double length = movie_length(plan.time(plan.steps));
  const auto count = static_cast<std::size_t>(std::llround(length * fps)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double place = share * static_cast<double>(plan.steps);
    const double step = std::floor(place + k_whole);
    const double alpha = place - step > k_whole ? place - step : 0;
    moments.push_back({.step = static_cast<long long>(step),
                       .alpha = static_cast<float>(alpha),
                       .use = Moment::Use::movie,
                       .index = i});
  }
}

/// A panel of the filmstrip is small: what is the same in all of them stands only once.
/// What the scene itself told stays.
void simplify_for_filmstrip(DrawList& list, std::size_t index,
                            const std::vector<std::string>& told) {
  const bool first = index == 0, last = index + 1 == k_filmstrip_length;
  if (!first) list.title.clear();
  if (!first) list.legend.clear();
  if (!last) list.caption = told;
  list.charts.clear();
}

/// Two thirds as high as a frame, no wider than 4:3, and so small that a PNG holds all.
glm::ivec2 panel_size(glm::ivec2 frame) {
  const int height = std::clamp(frame.y * 2 / 3, 48, 3000);
  return {std::min(frame.x * height / frame.y, height * 4 / 3), height};
}

}  // namespace

std::vector<Moment> plan_moments(const Plan& plan, const Recording& recording) {
  std::vector<Moment> moments;
  add_even_steps(moments, plan.steps, k_filmstrip_length, Moment::Use::filmstrip);
  add_even_steps(moments, plan.steps, recording.frames.size(), Moment::Use::frame);
  if (!recording.movie.empty()) add_movie(moments, plan, recording.fps);
  std::ranges::stable_sort(moments, [](const Moment& a, const Moment& b) {
    return std::tie(a.step, a.alpha) < std::tie(b.step, b.alpha);
  });
  return moments;
}

Recorder::Recorder(const Plan& plan, std::span<const Lane> lanes, const MetricLog& log,
                   Recording recording)
    : plan_(plan),
      lanes_(lanes),
      log_(log),
      camera_(usual_camera(plan, lanes)),
      recording_(std::move(recording)),
      moments_(plan_moments(plan, recording_)),
      studio_(std::make_unique<Studio>(recording_.size)) {
  if (recording_.movie.empty()) return;
  movie_ = std::make_unique<Movie>(recording_.ffmpeg, recording_.movie, recording_.size,
                                   recording_.fps);
}

Observer Recorder::observer() {
  return {.next = [this](long long) { return next_step(); },
          .see = [this](long long step) { see(step); }};
}

long long Recorder::next_step() const {
  if (due_ == moments_.size()) return plan_.steps;
  const Moment& moment = moments_[due_];
  const bool half_seen = moment.alpha > 0 && previous_step_ == moment.step;
  return moment.step + (half_seen ? 1 : 0);
}

void Recorder::see(long long step) {
  const DrawList current = draw_scene(lanes_);
  const auto due = [&](long long wanted, bool whole) {
    return due_ < moments_.size() && moments_[due_].step == wanted
           && (moments_[due_].alpha <= 0) == whole;
  };

  // Pictures between the previous step and this one, then those of this step
  for (; due(step - 1, false); ++due_) {
    const Moment& moment = moments_[due_];
    shoot(moment, interpolate(previous_, current, moment.alpha));
  }
  for (; due(step, true); ++due_) shoot(moments_[due_], current);

  if (due(step, false)) {
    previous_ = current;
    previous_step_ = step;
  }
}

void Recorder::shoot(const Moment& moment, DrawList list) {
  throw_if_interrupted();  // a large picture takes longer than many steps
  const double time =
      plan_.time(moment.step) + static_cast<double>(moment.alpha) * plan_.dt;
  const Scene& scene = *plan_.scene;
  const std::vector<std::string> told = list.caption;
  add_words(list, plan_, lanes_, time);
  add_chart(list, log_, scene.chart_metric, scene.chart_logarithmic);
  list.chart_side = Side::left;  // where a flight begins, not where it lands

  if (moment.use == Moment::Use::filmstrip) {
    simplify_for_filmstrip(list, moment.index, told);
    filmstrip_.push_back(std::move(list));
  } else if (moment.use == Moment::Use::frame) {
    write_png(studio_->render(list, camera_), recording_.frames[moment.index]);
  } else {
    const double seconds = plan_.time(plan_.steps);
    const double speed = seconds / movie_length(seconds);
    if (speed != 1) list.caption[0] += fmt::format(", shown at {:.3g}x speed", speed);
    movie_->add(studio_->render(list, camera_));
  }
}

Image Recorder::develop_filmstrip() {
  studio_.reset();
  studio_ = std::make_unique<Studio>(panel_size(recording_.size));
  std::vector<Image> panels;
  for (std::size_t i = 0; i < filmstrip_.size(); ++i) {
    const long long step = even_step(plan_.steps, i, k_filmstrip_length);
    const std::string time = fmt::format("t = {} s", short_text(plan_.time(step)));
    panels.push_back(studio_->render(filmstrip_[i], camera_, time));
  }
  return side_by_side(panels);
}

std::optional<std::string> Recorder::finish() {
  write_png(develop_filmstrip(), recording_.filmstrip);
  return movie_ ? movie_->finish() : std::nullopt;
}

}  // namespace timestep
