#include "chapters/04-contacts/concave_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/resource_manager.hpp"
#include "common/physics/simplex.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

// So that coordinates far from the origin cost no more digits than they have lost
void move_to_middle(ConcaveMesh& mesh, MeshData data) {
  Vec3 low = mesh.vertices[0], high = low;
  for (const Vec3& v : mesh.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const Vec3 middle = low / Real(2) + high / Real(2);
  mesh.half_extents = high / Real(2) - low / Real(2);
  for (Vec3& v : mesh.vertices) v -= middle;
  for (glm::vec3& p : data.positions) p = Vec3(p) - middle;
  mesh.shown = std::make_shared<const MeshData>(std::move(data));
}

// Vertices at the same place are one; triangles join theirs to one piece, whose number
// is that of one of its vertices
std::vector<std::size_t> piece_of_each(const ConcaveMesh& mesh) {
  std::vector<std::size_t> leader(mesh.vertices.size());
  const auto find = [&](std::size_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  std::map<std::array<Real, 3>, std::size_t> first_at;
  for (std::size_t i = 0; i < leader.size(); ++i) {
    const Vec3& v = mesh.vertices[i];
    leader[i] = first_at.try_emplace({v.x, v.y, v.z}, i).first->second;
  }
  for (const auto& [i, j, k] : mesh.triangles)
    leader[find(j)] = leader[find(k)] = find(i);
  for (std::size_t i = 0; i < leader.size(); ++i) leader[i] = find(i);
  return leader;
}

void find_pieces(ConcaveMesh& mesh) {
  std::map<std::size_t, std::vector<Vec3>> pieces;
  const std::vector<std::size_t> piece = piece_of_each(mesh);
  for (std::size_t i = 0; i < piece.size(); ++i)
    pieces[piece[i]].push_back(mesh.vertices[i]);
  for (auto& [_, vertices] : pieces) mesh.pieces.push_back(std::move(vertices));
}

}  // namespace

ConcaveMesh load_concave(const std::filesystem::path& file) {
  const std::filesystem::path found = find_asset("meshes", file);
  const auto refuse = [&](const std::string& fault) {
    throw InputError(fmt::format("mesh {}: {}", found.string(), fault));
  };
  MeshData data = load_mesh(found);
  ConcaveMesh mesh;
  mesh.vertices.assign(data.positions.begin(), data.positions.end());
  mesh.triangles = data.triangles;
  if (const std::string fault = mesh_fault(mesh.vertices, mesh.triangles);
      !fault.empty())
    refuse(fault);
  move_to_middle(mesh, std::move(data));
  find_pieces(mesh);
  mesh.volume = mesh_volume(mesh.vertices, mesh.triangles);
  if (!std::isnormal(mesh.volume))
    refuse(fmt::format("a volume of {:.3g} m³: too small or too large", mesh.volume));
  return mesh;
}

namespace {

// How much of a sphere about a point a triangle covers [sr], positive from inside
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double below =
      la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
}

}  // namespace

double distance_to_mesh(const ConcaveMesh& mesh, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity(), around = 0;
  for (const Triangle& triangle : mesh.triangles) {
    Simplex simplex;
    simplex.size = 3;
    std::array<glm::dvec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      simplex.vertices[i].w = mesh.vertices[triangle[i]] - point;
      corners[i] = glm::dvec3(simplex.vertices[i].w);
    }
    around += solid_angle(corners[0], corners[1], corners[2]);
    nearest =
        std::min(nearest, static_cast<double>(glm::length(reduce_to_closest(simplex))));
  }
  const bool inside = around > 2 * std::numbers::pi;
  return inside ? -nearest : nearest;
}

std::vector<ConvexHull> hulls_of_pieces(const ConcaveMesh& mesh) {
  std::vector<ConvexHull> hulls;
  for (const std::vector<Vec3>& piece : mesh.pieces) {
    ConvexHull hull = convex_hull(piece).hull;
    if (!hull.vertices.empty()) hulls.push_back(std::move(hull));
  }
  return hulls;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
