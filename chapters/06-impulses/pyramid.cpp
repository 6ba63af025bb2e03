// Boxes that each stand on two: a triangle, as high as its base is long.
#include <memory>

#include "chapters/06-impulses/standing.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class Pyramid : public Standing {
 public:
  explicit Pyramid(const Setup& setup);
  CameraPose camera(const CameraPose& usual) const override;
};

Pyramid::Pyramid(const Setup& setup) : Standing(setup) {
  const int base = static_cast<int>(parameter("base"));
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) {
      const double middle = (base - 1 - row) / 2.0;
      add_box({parameter("spacing") * (i - middle), 0.5 + row, 0});
    }
  }
}

CameraPose Pyramid::camera(const CameraPose& usual) const {
  CameraPose pose = WorldRun::camera(usual);
  const float base = static_cast<float>(parameter("base"));
  pose.target.y = 0.46F * base;
  pose.distance += 1.3F * base;
  return pose;
}

}  // namespace

Scene pyramid_scene() {
  return {
      .name = "pyramid",
      .summary = "rows of boxes, each box on two",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = standing_parameters(
          {{"base", "", "boxes in the lowest row", 20, 1, 50, true},
           {"spacing", "sizes", "from box to box in a row", 1.1, 1, 1.9}}),
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.distance = 2, .yaw = 0.35F, .pitch = 0.12F},
      .chart_metric = "penetration",
      .start = [](const Setup& setup) { return std::make_unique<Pyramid>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
