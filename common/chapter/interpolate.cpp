#include "common/chapter/interpolate.hpp"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace timestep {
namespace {

/// Moves each element of `list` towards its partner in `current`, if all have one.
template <typename T, typename Blend>
void blend_pairs(std::vector<T>& list, const std::vector<T>& current, Blend blend) {
  if (list.size() != current.size()) return;
  for (std::size_t i = 0; i < list.size(); ++i) blend(list[i], current[i]);
}

glm::vec3 lengths_of_columns(const glm::mat4& m) {
  return {glm::length(glm::vec3(m[0])), glm::length(glm::vec3(m[1])),
          glm::length(glm::vec3(m[2]))};
}

bool is_rotated_box(const glm::mat4& m) {
  return glm::determinant(glm::mat3(m)) > 0;  // neither flat nor mirrored
}

glm::quat rotation_of(const glm::mat4& m, const glm::vec3& scale) {
  return glm::normalize(
      glm::quat_cast(glm::mat3(glm::vec3(m[0]) / scale.x, glm::vec3(m[1]) / scale.y,
                               glm::vec3(m[2]) / scale.z)));
}

void blend_line(Polyline& line, const Polyline& current, float alpha) {
  const auto mix = [=](glm::vec3& a, const glm::vec3& b) { a = glm::mix(a, b, alpha); };
  if (line.points.size() == current.points.size()) {
    blend_pairs(line.points, current.points, mix);
    return;
  }

  // A trail that grew: its end moves towards the first new point
  const bool grew = !line.points.empty() && line.points.size() < current.points.size()
                    && line.points.back() == current.points[line.points.size() - 1];
  if (!grew) return;
  const glm::vec3 next = current.points[line.points.size()];
  line.points.push_back(glm::mix(line.points.back(), next, alpha));
}

}  // namespace

glm::mat4 interpolate(const glm::mat4& previous, const glm::mat4& current,
                      float alpha) {
  if (!is_rotated_box(previous) || !is_rotated_box(current)) {
    return previous * (1 - alpha) + current * alpha;
  }

  const glm::vec3 old_scale = lengths_of_columns(previous);
  const glm::vec3 new_scale = lengths_of_columns(current);
  const glm::quat rotation = glm::slerp(rotation_of(previous, old_scale),
                                        rotation_of(current, new_scale), alpha);
  const glm::vec3 scale = glm::mix(old_scale, new_scale, alpha);
  glm::mat4 result = glm::mat4_cast(rotation);
  for (int i = 0; i < 3; ++i) result[i] *= scale[i];
  result[3] = glm::mix(previous[3], current[3], alpha);
  return result;
}

DrawList interpolate(const DrawList& previous, const DrawList& current, float alpha) {
  if (alpha >= 1) return current;
  if (alpha <= 0) return previous;

  DrawList list = previous;
  const auto mix = [=](const auto& a, const auto& b) { return glm::mix(a, b, alpha); };
  blend_pairs(
      list.shapes, current.shapes, [=](ShapeInstance& a, const ShapeInstance& b) {
        a.world_from_shape = interpolate(a.world_from_shape, b.world_from_shape, alpha);
      });
  blend_pairs(list.meshes, current.meshes, [=](MeshInstance& a, const MeshInstance& b) {
    a.world_from_mesh = interpolate(a.world_from_mesh, b.world_from_mesh, alpha);
  });
  blend_pairs(list.balls, current.balls, [=](Ball& a, const Ball& b) {
    a = {mix(a.center, b.center), mix(a.radius, b.radius), mix(a.color, b.color)};
  });
  blend_pairs(list.lines, current.lines,
              [=](Polyline& a, const Polyline& b) { blend_line(a, b, alpha); });
  blend_pairs(list.arrows, current.arrows, [=](Arrow& a, const Arrow& b) {
    a.from = mix(a.from, b.from);
    a.to = mix(a.to, b.to);
  });
  blend_pairs(list.markers, current.markers, [=](Marker& a, const Marker& b) {
    a.position = mix(a.position, b.position);
  });
  blend_pairs(list.labels, current.labels, [=](Label& a, const Label& b) {
    a.position = mix(a.position, b.position);
  });
  return list;
}

}  // namespace timestep
