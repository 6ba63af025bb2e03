/// @file
/// Where something was in the last second.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace timestep {

/// Keeps at most 120 points a second; always the newest.
class RecentTrail {
 public:
  /// t: later than the last [s]
  void add(double t, const glm::vec3& place) {
    constexpr double k_apart = 0.99 / 120;
    if (points_.size() > 1 && t - points_[points_.size() - 2].t < k_apart)
      points_.pop_back();
    points_.push_back({t, place});
    std::erase_if(points_, [t](const Point& p) { return p.t < t - 1; });
  }

  std::vector<glm::vec3> points() const {
    std::vector<glm::vec3> places;
    for (const Point& p : points_) places.push_back(p.place);
    return places;
  }

 private:
  struct Point {
    double t;
    glm::vec3 place;
  };
  std::vector<Point> points_;
};

}  // namespace timestep
