#include "chapters/04-contacts/parts.hpp"

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_transform.hpp>

#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

std::vector<Method> all_choices() {
  std::vector<Method> all;
  for (const PairMethod& method : pair_methods())
    all.push_back({std::string(method.name), std::string(method.summary),
                   method_style(static_cast<int>(all.size()))});
  return all;
}

const PairMethod& method_named(const std::string& name) {
  return *std::ranges::find(pair_methods(), name, &PairMethod::name);
}

Pose pose_of(const Placement& placement) {
  return {Vec3(placement.position), Quat(placement.orientation)};
}

Color with_alpha(const Color& color, float alpha) {
  return {color.r, color.g, color.b, alpha};
}

std::shared_ptr<const MeshData> flat_mesh(std::span<const Vec3> vertices,
                                          std::span<const Triangle> triangles) {
  MeshData mesh;
  for (const auto& [i, j, k] : triangles) {
    const glm::dvec3 p(vertices[i]), q(vertices[j]), r(vertices[k]);
    const glm::dvec3 n = glm::cross(q - p, r - p);
    const double size = glm::length(n);
    if (!(size > 0)) continue;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& corner : {p, q, r}) {
      mesh.positions.emplace_back(corner);
      mesh.normals.emplace_back(n / size);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return std::make_shared<const MeshData>(std::move(mesh));
}

std::shared_ptr<const MeshData> hull_mesh(const ConvexHull& hull) {
  return flat_mesh(hull.vertices, hull_triangles(hull));
}

void draw_edges(DrawList& list, const ConvexHull& hull,
                const glm::mat4& world_from_hull, const Color& color) {
  const auto at = [&](std::uint32_t edge) {
    const Vec3& v = hull.vertices[hull.half_edges[edge].origin];
    return glm::vec3(world_from_hull * glm::vec4(picture(v), 1));
  };
  for (std::uint32_t e = 0; e < hull.half_edges.size(); ++e) {
    const std::uint32_t twin = hull.half_edges[e].twin;
    if (e < twin)
      list.lines.push_back({.points = {at(e), at(twin)}, .color = color, .width = 1});
  }
}

glm::mat4 placed(const glm::vec3& at, const glm::dquat& q, float scale) {
  glm::mat4 world_from_body = scale * glm::mat4_cast(glm::quat(q));
  world_from_body[3] = glm::vec4(at, 1);
  return world_from_body;
}

namespace {

// The picture's cylinder and cone stand on y; a quarter turn lays them along z
glm::mat4 along_z(float radius, float from, float to) {
  const glm::mat4 lifted =
      glm::translate(glm::mat4(1), glm::vec3(0, 0, (from + to) / 2));
  const glm::mat4 turned = glm::rotate(lifted, glm::radians(90.0F), glm::vec3(1, 0, 0));
  return glm::scale(turned, glm::vec3(radius, (to - from) / 2, radius));
}

struct UnitShape {
  ShapeKind kind;
  glm::mat4 body_from_unit;
};

UnitShape unit_shape(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return {ShapeKind::sphere,
            glm::scale(glm::mat4(1), glm::vec3(float(sphere->radius)))};
  if (const auto* box = std::get_if<Box>(&shape))
    return {ShapeKind::box, glm::scale(glm::mat4(1), picture(box->half_extents))};
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape))
    return {ShapeKind::sphere, glm::scale(glm::mat4(1), picture(ellipsoid->semi_axes))};
  if (const auto* c = std::get_if<Cylinder>(&shape))
    return {ShapeKind::cylinder,
            along_z(float(c->radius), -float(c->height) / 2, float(c->height) / 2)};
  if (const auto* cone = std::get_if<Cone>(&shape))
    return {ShapeKind::cone, along_z(float(cone->radius), 0, float(cone->height))};

  // A half-space below y = 0: the slab beneath
  const glm::mat4 below = glm::translate(glm::mat4(1), glm::vec3(0, -0.06F, 0));
  return {ShapeKind::box, glm::scale(below, glm::vec3(0.8F, 0.06F, 0.8F))};
}

}  // namespace

void draw_specimen(DrawList& list, const Specimen& specimen,
                   const glm::mat4& world_from_body, const Color& color) {
  if (specimen.mesh) {
    list.meshes.push_back({specimen.mesh, world_from_body, color});
    return;
  }
  const UnitShape unit = unit_shape(specimen.shape);
  list.shapes.push_back({unit.kind, world_from_body * unit.body_from_unit, color});
}

void draw_manifold(DrawList& list, const Manifold& manifold, const Color& color,
                   float arrow, const glm::vec3& shift) {
  const glm::vec3 n = picture(manifold.normal);
  const auto count = static_cast<std::size_t>(manifold.count);
  for (const ContactPoint& point : std::span(manifold.points).first(count)) {
    const glm::vec3 a = picture(on_a(manifold, point)) + shift;
    const glm::vec3 b = picture(on_b(manifold, point)) + shift;
    list.lines.push_back({.points = {a, b}, .color = color, .width = 3});
    list.arrows.push_back({.from = a, .to = a + arrow * n, .color = color, .width = 3});
    list.markers.push_back(
        {.position = a, .style = {color, MarkerShape::circle}, .size = 8});
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
