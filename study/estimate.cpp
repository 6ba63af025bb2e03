#include "study/estimate.hpp"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace timestep::study {

Estimate::Estimate(std::vector<Task> tasks) : tasks_(std::move(tasks)) {}

void Estimate::finish(double seconds) {
  const Task& task = tasks_.at(done_++);
  for (Pace* pace : {&paces_[task.group], &all_}) {
    pace->expected += task.expected;
    pace->seconds += seconds;
  }
}

double Estimate::seconds_left() const {
  double left = 0;
  for (std::size_t i = done_; i < tasks_.size(); ++i) {
    const auto known = paces_.find(tasks_[i].group);
    const Pace others = tasks_[i].is_known ? Pace{} : all_;
    const Pace& pace = known == paces_.end() ? others : known->second;
    const double slower = pace.expected > 0 ? pace.seconds / pace.expected : 1;
    left += tasks_[i].expected * slower;
  }
  return left;
}

std::string duration_text(double seconds) {
  constexpr double k_minute = 60, k_hour = 3600;
  if (seconds < 100) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 100 * k_minute) return fmt::format("{:.0f} min", seconds / k_minute);
  return fmt::format("{:.0f} h", seconds / k_hour);
}

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const Estimate& estimate, const std::string& what) {
  const double spent = estimate.seconds_spent(), left = estimate.seconds_left();
  const double share = spent + left > 0 ? spent / (spent + left) : 1;
  const int tenths = static_cast<int>(share * 10);
  if (!terminal_) {
    if (tenths <= tenths_) return;
    tenths_ = tenths;
    std::fputs(fmt::format("study: {}, {} %, {}/{}, about {} left\n", what, 10 * tenths,
                           estimate.done(), estimate.count(), duration_text(left))
                   .c_str(),
               stderr);
    return;
  }

  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  constexpr int k_width = 30;
  const auto full = static_cast<std::size_t>(share * k_width);
  const std::string bar = std::string(full, '#') + std::string(k_width - full, '.');
  std::fputs(fmt::format("\r\033[K{} [{}] {}/{}, about {} left", what, bar,
                         estimate.done(), estimate.count(), duration_text(left))
                 .c_str(),
             stderr);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace timestep::study
