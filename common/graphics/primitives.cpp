#include "common/graphics/primitives.hpp"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace timestep {
namespace {

constexpr int k_around = 48;
constexpr int k_rings = 24;

/// A point of an outline that is turned about y: radius, height and normal in its
/// plane.
struct OutlinePoint {
  glm::vec2 place, normal;
};

/// Turns an outline, listed from the top down, about the y axis. Pairs of points make
/// bands, so that an edge can have a normal for each side.
MeshData turned(const std::vector<std::pair<OutlinePoint, OutlinePoint>>& bands) {
  MeshData mesh;
  for (const auto& [top, bottom] : bands) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i <= k_around; ++i) {
      const float angle = static_cast<float>(i) / k_around * glm::two_pi<float>();
      const glm::vec3 outward{std::sin(angle), 0, std::cos(angle)};
      for (const OutlinePoint& p : {top, bottom}) {
        mesh.positions.push_back(outward * p.place.x + glm::vec3(0, p.place.y, 0));
        mesh.normals.push_back(outward * p.normal.x + glm::vec3(0, p.normal.y, 0));
      }
    }
    for (std::uint32_t i = first; i < first + 2 * k_around; i += 2) {
      mesh.triangles.push_back({i, i + 1, i + 2});
      mesh.triangles.push_back({i + 2, i + 1, i + 3});
    }
  }
  return mesh;
}

MeshData sphere() {
  const auto at = [](int ring) {
    const float angle = static_cast<float>(ring) / k_rings * glm::pi<float>();
    const glm::vec2 p{std::sin(angle), std::cos(angle)};
    return OutlinePoint{p, p};
  };
  std::vector<std::pair<OutlinePoint, OutlinePoint>> bands;
  for (int ring = 0; ring < k_rings; ++ring) bands.emplace_back(at(ring), at(ring + 1));
  return turned(bands);
}

MeshData cylinder() {
  const glm::vec2 up{0, 1}, down{0, -1}, out{1, 0};
  return turned({{{{0, 1}, up}, {{1, 1}, up}},
                 {{{1, 1}, out}, {{1, -1}, out}},
                 {{{1, -1}, down}, {{0, -1}, down}}});
}

MeshData cone() {
  const glm::vec2 down{0, -1};
  const glm::vec2 slope = glm::normalize(glm::vec2(2, 1));
  return turned(
      {{{{0, 1}, slope}, {{1, -1}, slope}}, {{{1, -1}, down}, {{0, -1}, down}}});
}

MeshData box() {
  MeshData mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      glm::vec3 normal{0}, u{0};
      normal[axis] = side;
      u[(axis + 1) % 3] = 1;
      const glm::vec3 v = glm::cross(normal, u);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const glm::vec3 corner : {-u - v, u - v, u + v, v - u}) {
        mesh.positions.push_back(normal + corner);
        mesh.normals.push_back(normal);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

}  // namespace

MeshData unit_mesh(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere:
      return sphere();
    case ShapeKind::box:
      return box();
    case ShapeKind::cylinder:
      return cylinder();
    case ShapeKind::cone:
      return cone();
  }
  return box();
}

}  // namespace timestep
