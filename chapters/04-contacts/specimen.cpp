#include "chapters/04-contacts/specimen.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "chapters/04-contacts/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

using Points = std::vector<glm::dvec3>;

// Evenly spread over the unit sphere, along a spiral
Points spiral(int count) {
  Points points;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double r = std::sqrt(1 - z * z);
    points.emplace_back(r * std::cos(turn * i), r * std::sin(turn * i), z);
  }
  return points;
}

Points unit_points(int kind) {
  const double r = std::sqrt(0.75);
  if (kind == k_tetrahedron)
    return {{1, 0, -0.5}, {-0.5, r, -0.5}, {-0.5, -r, -0.5}, {0, 0, 1}};
  if (kind == k_tetrahedron + 1) return spiral(24);
  if (kind == k_triangle) return {{1, -0.8, 0}, {-0.2, 1, 0}, {-1, -0.6, 0}};
  return {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
}

Shape round_shape(const Description& d) {
  const Real s = Real(d.size), length = Real(d.size * d.stretch);
  switch (d.kind) {
    case 0:
      return Sphere{s};
    case 1:
      return Box{{s, s, length}};
    case 2:
      return Ellipsoid{{s, Real(0.7) * s, length}};
    case 3:
      return Capsule{s / 2, length};
    case 4:
      return Cylinder{s, 2 * length};
    case 5:
      return Cone{s, 2 * length};
    default:
      return HalfSpace{{0, 1, 0}, 0};
  }
}

// Of a smooth shape, whose normal at its support point is the direction
std::shared_ptr<const MeshData> support_mesh(const Capsule& capsule) {
  constexpr std::uint32_t k_around = 32, k_rows = 17;
  MeshData mesh;
  for (std::uint32_t row = 0; row <= k_rows; ++row) {
    for (std::uint32_t i = 0; i < k_around; ++i) {
      const double polar = std::numbers::pi * row / k_rows;
      const double turn = 2 * std::numbers::pi * i / k_around;
      const Vec3 n(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                   std::cos(polar));
      mesh.positions.push_back(picture(support(capsule, n)));
      mesh.normals.push_back(picture(n));
      const std::uint32_t p = row * k_around + i,
                          q = row * k_around + (i + 1) % k_around;
      if (row == k_rows) continue;
      mesh.triangles.push_back({p, p + k_around, q});
      mesh.triangles.push_back({q, p + k_around, q + k_around});
    }
  }
  return std::make_shared<const MeshData>(std::move(mesh));
}

}  // namespace

Specimen::Specimen(const Description& d) : shape(round_shape(d)) {
  if (const auto* capsule = std::get_if<Capsule>(&shape)) mesh = support_mesh(*capsule);
  if (d.kind < k_tetrahedron || d.kind == k_half_space) return;
  for (const glm::dvec3& p : unit_points(d.kind))
    vertices.emplace_back(d.size * p * glm::dvec3(1, 1, d.stretch));
  if (d.kind < k_triangle) {
    hull = convex_hull(vertices).hull;
    shape = hull_shape(hull);
    mesh = hull_mesh(hull);
  } else {
    const std::array<Triangle, 2> halves{{{0, 1, 2}, {0, 2, 3}}};
    shape = hull_shape(vertices);
    mesh = flat_mesh(vertices, std::span(halves).first(vertices.size() - 2));
  }
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
