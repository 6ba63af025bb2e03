#include "common/chapter/runner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "common/chapter/interrupt.hpp"
#include "common/chapter/numbers.hpp"

namespace timestep {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// What reading the clock costs by itself [s], to be taken off each reading: a step of
/// a single particle takes less than that.
double clock_overhead() {
  static const double overhead = [] {
    double least = 1;
    for (int i = 0; i < 1000; ++i) {
      const auto begin = Clock::now();
      least = std::min(least, seconds(Clock::now() - begin));
    }
    return least;
  }();
  return overhead;
}

std::unique_ptr<Simulation> start(const Plan& plan, const Setup& setup) {
  std::unique_ptr<Simulation> simulation = plan.scene->start(setup);
  simulation->observe();
  return simulation;
}

void timed_step(Lane& lane) {
  const auto begin = Clock::now();
  lane.simulation->step();
  const double spent = seconds(Clock::now() - begin) - clock_overhead();
  lane.wall_seconds += std::max(spent, 0.0);
}

/// Stops short at a step that cannot be taken: the lane has failed there.
void advance(const Plan& plan, Lane& lane, long long to) {
  for (; lane.steps < to; ++lane.steps) {
    throw_if_interrupted();
    try {
      timed_step(lane);
    } catch (const StepFailure& failure) {
      lane.failure = Failure{lane.steps + 1, plan.time(lane.steps + 1), failure.what()};
      lane.bodies = lane.simulation->bodies();
      lane.metrics = lane.simulation->metrics();
      return;
    }
    lane.simulation->observe();
  }
}

std::optional<std::string> not_finite(const BodyState& body) {
  const auto finite = [](const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  if (!finite(body.position)) return "position of " + body.name;
  if (!finite(body.velocity)) return "velocity of " + body.name;
  if (body.orientation) {
    const glm::dquat& q = *body.orientation;
    if (!std::isfinite(q.w + q.x + q.y + q.z)) return "orientation of " + body.name;
  }
  if (body.angular_velocity && !finite(*body.angular_velocity)) {
    return "angular velocity of " + body.name;
  }
  return std::nullopt;
}

std::optional<std::string> not_finite(const Lane& lane) {
  for (const BodyState& body : lane.bodies) {
    if (const auto what = not_finite(body)) return *what + " is not finite";
  }
  for (const Metric& metric : lane.metrics) {
    if (std::isfinite(metric.value)) continue;
    return fmt::format("{} is {}", metric.name, exact_text(metric.value));
  }
  return std::nullopt;
}

/// Takes bodies and metrics; whether all are finite.
bool sample(const Plan& plan, Lane& lane) {
  lane.bodies = lane.simulation->bodies();
  lane.metrics = lane.simulation->metrics();
  if (const auto what = not_finite(lane)) {
    lane.failure = Failure{lane.steps, plan.time(lane.steps), *what};
  }
  return !lane.failure;
}

/// Runs a lane that failed somewhere after `good` again, looking after every step.
void stop_at_first_failure(const Plan& plan, Lane& lane, long long good) {
  const long long bad = lane.steps;
  if (bad <= good + 1) return;

  Lane again{.setup = lane.setup, .simulation = start(plan, *lane.setup)};
  advance(plan, again, good);
  while (again.steps < bad && sample(plan, again))
    advance(plan, again, again.steps + 1);
  sample(plan, again);
  lane = std::move(again);
}

}  // namespace

std::vector<Lane> start_lanes(const Plan& plan) {
  std::vector<Lane> lanes;
  for (const Setup& setup : plan.setups) {
    lanes.push_back({.setup = &setup, .simulation = start(plan, setup)});
  }
  return lanes;
}

std::vector<std::string> notices(std::span<const Lane> lanes) {
  std::vector<std::string> all;
  for (const Lane& lane : lanes)
    for (const std::string& line : lane.simulation->notices())
      if (std::ranges::find(all, line) == all.end()) all.push_back(line);
  return all;
}

CameraPose usual_camera(const Plan& plan, std::span<const Lane> lanes) {
  const CameraPose& camera = plan.scene->camera;
  return lanes.empty() ? camera : lanes.front().simulation->camera(camera);
}

void advance_lanes(const Plan& plan, std::span<Lane> lanes, long long step) {
  for (Lane& lane : lanes) {
    if (!lane.failure) advance(plan, lane, step);
  }
}

void sample_lanes(const Plan& plan, std::span<Lane> lanes, long long last_good) {
  for (Lane& lane : lanes) {
    if (!lane.failure && !sample(plan, lane))
      stop_at_first_failure(plan, lane, last_good);
  }
}

long long sample_stride(double dt) {
  const double steps = std::ceil(1 / (60 * dt) - 1e-9);  // infinite if dt is tiny
  return static_cast<long long>(std::clamp(steps, 1.0, k_max_steps));
}

void run_lanes(const Plan& plan, std::span<Lane> lanes,
               std::span<const Observer> observers,
               const std::function<void(double)>& progress) {
  const long long stride = sample_stride(plan.dt);
  long long last_sample = 0;
  for (long long step = 0;;) {
    advance_lanes(plan, lanes, step);
    if (step % stride == 0 || step == plan.steps) {
      sample_lanes(plan, lanes, last_sample);
      last_sample = step;
    }

    // Let those look who asked for this step, and find the next one to stop at
    long long next = std::min((step / stride + 1) * stride, plan.steps);
    for (const Observer& observer : observers) {
      if (observer.next(step) == step) observer.see(step);
      next = std::min(next, std::max(observer.next(step + 1), step + 1));
    }
    progress(static_cast<double>(step) / static_cast<double>(plan.steps));
    if (step == plan.steps) return;
    step = next;
  }
}

}  // namespace timestep
