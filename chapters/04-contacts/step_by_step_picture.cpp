// GJK and EPA, one iteration a step: the pictures, and what they say in words.
#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "chapters/04-contacts/step_by_step.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

constexpr Color k_simplex{0.05F, 0.36F, 0.62F, 1};
constexpr Color k_nearest = k_force;
constexpr Color k_support{0.38F, 0.27F, 0.56F, 1};

// A face that went is one that its neighbours no longer know
bool is_live(const Polytope& polytope, int face) {
  const std::int16_t beyond = polytope.faces[std::size_t(face)].neighbours[0];
  const auto& back = polytope.faces[std::size_t(beyond)].neighbours;
  return std::ranges::find(back, face) != back.end();
}

const char* name_of_simplex(int size) {
  constexpr std::array k_names{"", "a point", "a segment", "a triangle",
                               "a tetrahedron"};
  return k_names[static_cast<std::size_t>(size)];
}

}  // namespace

glm::vec3 StepByStep::in_picture(const Vec3& w) const {
  return right_ + picture(w * difference_.unit);
}

std::vector<glm::vec3> StepByStep::in_picture(
    std::span<const SupportPoint> points) const {
  std::vector<glm::vec3> all;
  for (const SupportPoint& p : points) all.push_back(in_picture(p.w));
  return all;
}

// The shapes, and on each the point that the support point comes from
void StepByStep::draw_shapes(DrawList& list) const {
  const glm::vec3 b_at = left_ + picture(pose_b_.position);
  const glm::dquat b_turn(pose_b_.orientation);
  draw_specimen(list, a_, placed(left_, {1, 0, 0, 0}), k_color_a);
  draw_specimen(list, b_, placed(b_at, b_turn), with_alpha(k_color_b, 0.45F));
  list.labels.push_back({left_ + glm::vec3(-0.3F, 0, 0), "A", k_ink});
  list.labels.push_back({b_at + glm::vec3(0.35F, 0.3F, 0), "B", k_ink});
  const Simplex& simplex = gjk_.simplex;
  if (!in_epa_ && !gjk_.done) {
    const Style look{k_support, MarkerShape::diamond};
    const glm::vec3 a = left_ + picture(next_.a);
    const glm::vec3 b = left_ + picture(point_in_world(pose_b_, next_.b));
    list.lines.push_back(
        {.points = {a, b}, .color = k_support, .width = 1.5F, .dash = Dash::dashed});
    list.markers.push_back({a, look, 13});
    list.markers.push_back({b, look, 13});
  }
  if (!in_epa_) {
    const glm::vec3 a = left_ + picture(witness_on_a(simplex));
    const glm::vec3 b = left_ + picture(point_in_world(pose_b_, witness_on_b(simplex)));
    list.lines.push_back({.points = {a, b}, .color = k_nearest, .width = 3});
    for (const glm::vec3& p : {a, b})
      list.markers.push_back({p, {k_nearest, MarkerShape::circle}, 9});
  }
}

// A square of the plane through the support point, at right angles to the direction;
// of flat shapes a line
void StepByStep::draw_support(DrawList& list) const {
  constexpr Real k_side = Real(0.28);
  const Vec3 along =
      all_flat() ? glm::cross(towards_, Vec3(0, 0, 1)) : any_perpendicular(towards_);
  const Vec3 up = all_flat() ? Vec3(0) : glm::cross(towards_, along);
  std::vector<glm::vec3> square;
  for (const auto& [s, t] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}})
    square.push_back(in_picture(next_.w + k_side * (Real(s) * along + Real(t) * up)));
  list.lines.push_back(
      {.points = square, .color = k_support, .width = 1.5F, .dash = Dash::dashed});
  const glm::vec3 w = in_picture(next_.w);
  list.markers.push_back({w, {k_support, MarkerShape::diamond}, 14});
  list.labels.push_back({w, "w", k_support});
}

void StepByStep::draw_simplex(DrawList& list) const {
  const auto count = static_cast<std::size_t>(gjk_.simplex.size);
  const auto points = in_picture(std::span(gjk_.simplex.vertices).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    list.markers.push_back({points[i], {k_simplex, MarkerShape::circle}, 12});
    for (std::size_t j = 0; j < i; ++j)
      list.lines.push_back(
          {.points = {points[i], points[j]}, .color = k_simplex, .width = 3.5F});
  }
  if (cores_meet(gjk_)) return;
  const glm::vec3 v = in_picture(gjk_.v);
  list.arrows.push_back(
      {.from = in_picture(Vec3(0)), .to = v, .color = k_nearest, .width = 4});
  list.labels.push_back({v, "v", k_nearest});
  if (!gjk_.done) draw_support(list);
}

void StepByStep::draw_polytope(DrawList& list) const {
  const Polytope& polytope = epa_.polytope;
  const int closest = closest_face(polytope);
  std::vector<Vec3> vertices;
  std::vector<Triangle> others, nearest;
  for (int i = 0; i < polytope.vertex_count; ++i)
    vertices.push_back(polytope.vertices[std::size_t(i)].w);
  for (int i = 0; i < polytope.face_count; ++i) {
    if (!is_live(polytope, i)) continue;
    const auto& [p, q, r] = polytope.faces[std::size_t(i)].vertices;
    const auto at = [&](int v) { return in_picture(vertices[std::size_t(v)]); };
    (i == closest ? nearest : others)
        .push_back({std::uint32_t(p), std::uint32_t(q), std::uint32_t(r)});
    list.lines.push_back(
        {.points = {at(p), at(q), at(r), at(p)}, .color = k_simplex, .width = 2});
  }
  const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1), right_),
                                     glm::vec3(float(difference_.unit)));
  list.meshes.push_back(
      {flat_mesh(vertices, others), place, with_alpha(k_simplex, 0.25F)});
  list.meshes.push_back(
      {flat_mesh(vertices, nearest), place, with_alpha(k_nearest, 0.6F)});
  for (const Vec3& w : vertices)
    list.markers.push_back({in_picture(w), {k_simplex, MarkerShape::circle}, 9});
}

void StepByStep::tell_gjk(DrawList& list) const {
  const double v = length(upper_), gain = length(upper_ - lower_);
  const char* const simplex = name_of_simplex(gjk_.simplex.size);
  if (gjk_.done && cores_meet(gjk_)) {
    list.caption.push_back(
        fmt::format("GJK, step {}: {} holds the origin O", iteration_, simplex));
    list.caption.emplace_back(
        "So the shapes have a point in common; how deep, EPA tells");
    return;
  }
  list.caption.push_back(
      fmt::format("GJK, step {}: of {}, v is nearest to the origin O, {} m away",
                  iteration_, simplex, short_text(v)));
  if (gjk_.done) {
    list.caption.emplace_back(
        "No point of the difference is nearer: v is the distance");
  } else if (gain > length(k_rounding)) {
    list.caption.push_back(
        fmt::format("Against v, the farthest point is w, {} m past v: it joins them",
                    short_text(gain)));
  } else {
    list.caption.emplace_back(
        "Against v, even the farthest point w is not past v: nothing is nearer");
  }
}

void StepByStep::tell_epa(DrawList& list) const {
  if (epa_.reason == Reason::flat) {
    list.caption.emplace_back("EPA: the difference is flat, so the depth is across it");
    return;
  }
  const double offset = length(lower_), gain = length(upper_ - lower_);
  list.caption.push_back(fmt::format(
      "EPA, step {}: of {} points' hull, the red face is nearest to O, {} m",
      iteration_, epa_.polytope.vertex_count, short_text(offset)));
  if (done_)
    list.caption.emplace_back(
        "Nothing is beyond it: that is the depth, and its normal the direction");
  else if (gain > length(k_rounding))
    list.caption.push_back(
        fmt::format("Beyond it, the farthest point is w, by {} m: it joins them",
                    short_text(gain)));
  else
    list.caption.emplace_back(
        "No point w is beyond it: it is the difference's own face");
}

void StepByStep::draw(DrawList& list) const {
  draw_shapes(list);
  const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1), right_),
                                     glm::vec3(float(difference_.unit)));
  if (hull_mesh_) {
    list.meshes.push_back({hull_mesh_, place, with_alpha(k_body, 0.3F)});
    if (hull_.vertices.size() < 100) draw_edges(list, hull_, place, k_muted);
  }
  list.ground_height.reset();
  list.labels.push_back({right_ + top_, "B - A", k_muted});
  const glm::vec3 origin = in_picture(Vec3(0));
  list.markers.push_back({origin, {k_ink, MarkerShape::plus}, 16});
  list.labels.push_back({origin, "O", k_ink});

  if (!in_epa_) {
    draw_simplex(list);
    tell_gjk(list);
    return;
  }
  const glm::vec3 nearest = in_picture(-towards_ * lower_);
  list.arrows.push_back(
      {.from = origin, .to = nearest, .color = k_nearest, .width = 4});
  if (epa_.reason != Reason::flat) draw_polytope(list);
  if (!done_) draw_support(list);
  tell_epa(list);
}

void StepByStep::draw_reference(DrawList& list) const {
  list.legend.push_back({{k_simplex, MarkerShape::circle}, "simplex, polytope"});
  list.legend.push_back({{k_nearest, MarkerShape::circle}, "nearest to the origin O"});
  list.legend.push_back(
      {{k_support, MarkerShape::diamond, Dash::dashed}, "support point w, its plane"});
}

// Flat shapes are seen from the front
CameraPose StepByStep::camera(const CameraPose& usual) const {
  CameraPose pose = usual;
  const float width = 2 * std::max(-left_.x, right_.x) + 1.4F;
  pose.distance = std::max(4.0F, 1.08F * width);
  if (all_flat()) pose.yaw = pose.pitch = 0;
  return pose;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
