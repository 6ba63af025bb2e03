#include "common/chapter/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "common/chapter/numbers.hpp"

namespace timestep {
namespace {

bool showable(const glm::vec3& point) {
  constexpr float k_far = 1e9F;
  return std::abs(point.x) < k_far && std::abs(point.y) < k_far
         && std::abs(point.z) < k_far;  // false for NaN as well
}

bool showable(const glm::mat4& m) {
  return showable(glm::vec3(m[0])) && showable(glm::vec3(m[1]))
         && showable(glm::vec3(m[2])) && showable(glm::vec3(m[3]));
}

void drop_unshowable(DrawList& list) {
  std::erase_if(list.shapes,
                [](const ShapeInstance& s) { return !showable(s.world_from_shape); });
  std::erase_if(list.meshes,
                [](const MeshInstance& m) { return !showable(m.world_from_mesh); });
  std::erase_if(list.balls, [](const Ball& b) {
    return !showable(b.center) || !showable(glm::vec3(b.radius));
  });
  for (Polyline& line : list.lines) {
    std::erase_if(line.points, [](const glm::vec3& p) { return !showable(p); });
  }
  std::erase_if(list.arrows,
                [](const Arrow& a) { return !showable(a.from) || !showable(a.to); });
  std::erase_if(list.markers, [](const Marker& m) { return !showable(m.position); });
  std::erase_if(list.labels, [](const Label& l) { return !showable(l.position); });
}

std::string legend_text(const Lane& lane) {
  if (!lane.failure) return lane.setup->method;
  return fmt::format("{} (failed at {} s)", lane.setup->method,
                     short_text(lane.failure->time));
}

std::string headline(const Lane& lane) {
  if (lane.failure) return lane.setup->method + ": " + lane.failure->what;
  const Metric& metric = lane.metrics.front();
  return fmt::format("{}: {} {} {}", lane.setup->method, metric.name,
                     short_text(metric.value), metric.unit);
}

}  // namespace

DrawList draw_scene(std::span<const Lane> lanes) {
  DrawList list;
  lanes.front().simulation->draw_reference(list);
  for (const Lane& lane : lanes) {
    if (!lane.failure) lane.simulation->draw(list);
  }
  drop_unshowable(list);
  return list;
}

void add_words(DrawList& list, const Plan& plan, std::span<const Lane> lanes,
               double time) {
  // What the scene itself tells of this moment comes last
  const std::vector<std::string> told = std::exchange(list.caption, {});
  list.title = plan.chapter->title + ": " + plan.scene->name;
  list.caption.push_back(fmt::format("t = {:.2f} s, dt = {}, {} precision", time,
                                     step_text(plan.dt), name(plan.precision)));
  for (const Lane& lane : lanes) {
    if (!lane.metrics.empty()) list.caption.push_back(headline(lane));
    list.legend.push_back({lane.setup->style, legend_text(lane)});
  }
  list.caption.insert(list.caption.end(), told.begin(), told.end());
}

void add_chart(DrawList& list, const MetricLog& log, const std::string& metric,
               bool logarithmic) {
  if (!metric.empty()) list.charts.push_back(log.chart(metric, logarithmic));
}

}  // namespace timestep
