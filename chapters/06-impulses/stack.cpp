// Boxes on top of each other: impulses must find their way through all of them.
#include <algorithm>
#include <cmath>
#include <memory>

#include "chapters/06-impulses/standing.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class Stack : public Standing {
 public:
  explicit Stack(const Setup& setup);
  CameraPose camera(const CameraPose& usual) const override;
};

// Every other one is a little aside
Stack::Stack(const Setup& setup) : Standing(setup) {
  const int n = static_cast<int>(parameter("n"));
  const double aside = parameter("aside");
  for (int i = 0; i < n; ++i)
    add_box({i % 2 == 0 ? 0 : aside, 0.5 + i * (1 + parameter("gap")), 0});
}

CameraPose Stack::camera(const CameraPose& usual) const {
  CameraPose pose = WorldRun::camera(usual);
  const float high = static_cast<float>(parameter("n"));
  pose.target.y = 0.48F * high;
  pose.distance += 1.3F * high;
  return pose;
}

}  // namespace

Scene stack_scene() {
  return {
      .name = "stack",
      .summary = "boxes on top of each other",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = standing_parameters(
          {{"n", "", "boxes", 10, 1, 200, true},
           {"aside", "sizes", "of every other box", 0, -0.5, 0.5},
           {"gap", "sizes", "between boxes at the start", 0, -0.5, 10}}),
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.distance = 2.5F, .yaw = 0.5F, .pitch = 0.1F},
      .chart_metric = "penetration",
      .start = [](const Setup& setup) { return std::make_unique<Stack>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
