#include "common/chapter/tables.hpp"

#include <algorithm>
#include <utility>

#include <fmt/ostream.h>

#include "common/chapter/numbers.hpp"
#include "common/chapter/results.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

constexpr std::size_t k_most_bodies = 64;

/// A cell in quotes if it must be.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string cells(const glm::dvec3& v) {
  return exact_text(v.x) + "," + exact_text(v.y) + "," + exact_text(v.z);
}

std::string cells(const glm::dquat& q) {
  return exact_text(q.w) + "," + cells(glm::dvec3(q.x, q.y, q.z));
}

bool rotates(const BodyState& body) {
  return body.orientation.has_value() || body.angular_velocity.has_value();
}

}  // namespace

Tables::Tables(const std::filesystem::path& trajectory,
               const std::filesystem::path& history)
    : trajectory_(trajectory), history_(history) {}

void Tables::add_headings(std::span<const Lane> lanes) {
  fmt::print(history_, "time");
  for (const Lane& lane : lanes) {
    has_rotation_ = has_rotation_ || std::ranges::any_of(lane.bodies, rotates);
    for (const Metric& metric : lane.metrics) {
      fmt::print(history_, ",{}", cell(lane_prefix(lanes, lane) + metric.name));
    }
  }
  fmt::print(history_, "\n");
  fmt::print(trajectory_, "time,body,x,y,z,vx,vy,vz{}\n",
             has_rotation_ ? ",qw,qx,qy,qz,wx,wy,wz" : "");
}

void Tables::add_body(double time, const std::string& prefix, const BodyState& body) {
  fmt::print(trajectory_, "{},{},{},{}", exact_text(time), cell(prefix + body.name),
             cells(body.position), cells(body.velocity));
  if (has_rotation_) {
    fmt::print(trajectory_, ",{},{}",
               body.orientation ? cells(*body.orientation) : ",,,",
               body.angular_velocity ? cells(*body.angular_velocity) : ",,");
  }
  fmt::print(trajectory_, "\n");
}

void Tables::add(double time, std::span<const Lane> lanes) {
  if (!std::exchange(started_, true)) add_headings(lanes);

  fmt::print(history_, "{}", exact_text(time));
  for (const Lane& lane : lanes) {
    for (const Metric& metric : lane.metrics) {
      fmt::print(history_, ",{}", lane.failure ? "" : exact_text(metric.value));
    }
    if (lane.failure) continue;
    const std::size_t count = std::min(lane.bodies.size(), k_most_bodies);
    for (const BodyState& body : std::span(lane.bodies).first(count)) {
      add_body(time, lane_prefix(lanes, lane), body);
    }
  }
  fmt::print(history_, "\n");
}

void Tables::finish() {
  trajectory_.close();
  history_.close();
  if (!trajectory_ || !history_) {
    throw InputError("--out: cannot write trajectory.csv and history.csv to the end");
  }
}

}  // namespace timestep
