#include "common/chapter/session.hpp"

#include <algorithm>
#include <cmath>

#include "common/chapter/interpolate.hpp"
#include "common/chapter/picture.hpp"

namespace timestep {

Session::Session(const Chapter& chapter, const Choice& choice) {
  try {
    plan_ = make_plan(chapter, choice);
    begin();
  } catch (const std::exception& error) {
    error_ = error.what();
    lanes_.clear();
  }
}

void Session::begin() {
  lanes_ = start_lanes(plan_);
  log_ = {};
  clock_ = {};
  step_ = 0;
  take_sample();
  previous_ = current_ = draw_scene(lanes_);
}

void Session::advance(double frame_time, double speed) {
  if (lanes_.empty()) return;
  constexpr double k_longest_frame = 0.1;  // [s]; beyond it, time is dropped
  clock_.dt = plan_.dt;
  clock_.max_steps_per_frame =
      static_cast<int>(std::clamp(k_longest_frame * speed / plan_.dt, 1.0, 1e6));
  const int steps = clock_.advance(frame_time * speed);
  if (steps > 0 && !ended()) advance_to(std::min(step_ + steps, plan_.steps));
}

void Session::step_once() {
  if (lanes_.empty() || ended()) return;
  advance_to(step_ + 1);
  previous_ = current_;  // shown at once, not a step later
}

void Session::step_back() {
  if (lanes_.empty() || step_ == 0) return;
  const long long step = step_ - 1;
  begin();
  advance_to(step);
  previous_ = current_;
}

void Session::advance_to(long long step) {
  const long long stride = sample_stride(plan_.dt);
  while (step_ < step) {
    const long long next = std::min((step_ / stride + 1) * stride, step);
    if (next == step) {
      advance_lanes(plan_, lanes_, step - 1);
      previous_ = draw_scene(lanes_);
    }
    advance_lanes(plan_, lanes_, next);
    step_ = next;
    take_sample();
  }
  current_ = draw_scene(lanes_);
}

void Session::take_sample() {
  sample_lanes(plan_, lanes_, step_);
  log_.add(time(), lanes_);
}

DrawList Session::picture() const {
  if (ended()) return current_;
  return interpolate(previous_, current_, static_cast<float>(clock_.alpha()));
}

}  // namespace timestep
