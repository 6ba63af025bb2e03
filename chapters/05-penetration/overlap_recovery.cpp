// A pile of boxes that somebody has put inside of each other.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "chapters/05-penetration/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

class OverlapRecovery : public OverlapRun {
 public:
  explicit OverlapRecovery(const Setup& setup);

 private:
  void watch() override;
  void add_metrics(std::vector<Metric>& metrics) const override;
  Place right(int box) const;
  int count() const { return static_cast<int>(parameter("boxes")); }

  double hop_max_ = 0;
};

OverlapRecovery::OverlapRecovery(const Setup& setup)
    : OverlapRun(setup, {.apart = {2, 0}, .columns = 5, .mark = {0, 0.1F, 1}}) {
  add_wall({0, 1, 0}, 0);
  const double rise = size() * (1 - parameter("overlap"));
  for (int i = 0; i < count(); ++i) {
    Place start = right(i);
    start.position.y = rise * (i + 1) - size() / 2;
    const Shape shape = Box{Vec3(Real(size() / 2))};
    const double mass = parameter("mass") * std::pow(parameter("ratio"), i);
    add_body(fmt::format("box {}", i + 1).c_str(), solid(mass, shape, start), shape,
             right(i));
  }
}

// As high as it is when nothing overlaps, and as far aside as it was put
Place OverlapRecovery::right(int box) const {
  const double aside = parameter("aside") * size() * (box % 2 == 0 ? 0.5 : -0.5);
  return {.position = {aside, size() * (box + 0.5), 0}};
}

// How far above its right place any of the boxes has been
void OverlapRecovery::watch() {
  for (int i = 0; i < count(); ++i) {
    const double height = double(body(static_cast<std::size_t>(i)).position.y);
    hop_max_ = std::max(hop_max_, height - right(i).position.y);
  }
}

void OverlapRecovery::add_metrics(std::vector<Metric>& metrics) const {
  double needed = 0;
  int standing = 0;
  for (int i = 0; i < count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const glm::dvec3 there = right(i).position + glm::dvec3(origin(), 0, 0);
    const double weight = parameter("gravity") / double(body(index).inverse_mass);
    needed += weight * (there.y - start_of(index).position.y);
    const double off = glm::distance(glm::dvec3(body(index).position), there);
    standing += off < size() / 4 ? 1 : 0;
  }
  metrics.push_back({"hop_max", "m", hop_max_});
  metrics.push_back({"energy_needed", "J", needed});
  metrics.push_back({"standing", "", static_cast<double>(standing)});
}

}  // namespace

Scene overlap_recovery_scene() {
  return {
      .name = "overlap-recovery",
      .summary = "a pile of boxes that starts inside itself",
      .methods = all_choices(),
      .default_methods = all_names(),
      .parameters = with_settings(
          {{"boxes", "", "in the pile", 10, 1, 100, true},
           {"overlap", "", "of each with the one below, in sizes", 0.1, 0, 1},
           {"aside", "", "how far each is shifted, in sizes", 0, 0, 1},
           {"mass", "kg", "of the lowest", 1, 1e-9, 1e9},
           {"ratio", "", "mass of each over the one below", 1, 0.1, 10}},
          {.iterations = 200, .slop = 5e-4, .gravity = 9.81}),
      .presets = {{"resting",
                   "closed form: chapter 5, (5.4)",
                   {{"boxes", 1}, {"overlap", 0.05}, {"slop", 0.01}, {"gravity", 0}}},
                  {"one-box", "made for this chapter", {{"boxes", 1}}}},
      .dt = 1.0 / 60,
      .duration = 2,
      .camera = {.target = {0, 6.5F, 0}, .distance = 20, .yaw = 0.2F, .pitch = 0.08F},
      .chart_metric = "penetration",
      .start =
          [](const Setup& setup) { return std::make_unique<OverlapRecovery>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
