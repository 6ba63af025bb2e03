/// @file
/// Where something has been: a line that stays short however long the run.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace timestep {

/// Keeps at most 2,000 evenly spaced points of those added; always the newest.
class Trail {
 public:
  void add(const glm::vec3& point) {
    if (count_++ % stride_ != 0) {
      newest_ = point;
      return;
    }
    points_.push_back(newest_ = point);

    // Full: drop every second point and from now on take half as many
    if (points_.size() < k_capacity) return;
    for (std::size_t i = 0; i < k_capacity / 2; ++i) points_[i] = points_[2 * i];
    points_.resize(k_capacity / 2);
    stride_ *= 2;
  }

  std::vector<glm::vec3> points() const {
    std::vector<glm::vec3> all = points_;
    if (!all.empty() && all.back() != newest_) all.push_back(newest_);
    return all;
  }

 private:
  static constexpr std::size_t k_capacity = 2000;
  std::vector<glm::vec3> points_;
  glm::vec3 newest_{0};
  std::size_t count_ = 0, stride_ = 1;
};

}  // namespace timestep
