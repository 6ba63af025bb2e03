#include "chapters/01-particles/emitter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/chapter/random.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_01 {
namespace {

constexpr std::uint64_t k_seed = 1;
constexpr float k_size = 2;  // of a mesh, its longest side [m]

struct Triangle {
  glm::dvec3 a, b, c;
};

Triangle triangle(const MeshData& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {glm::dvec3(mesh.positions[a]), glm::dvec3(mesh.positions[b]),
          glm::dvec3(mesh.positions[c])};
}

}  // namespace

std::vector<exact::Motion> emit_from_nozzle(std::size_t n, double speed,
                                            double spread) {
  Random random(k_seed);
  std::vector<exact::Motion> starts(n);
  for (auto& [x, v] : starts) {
    // Evenly over the disc, then evenly over the cap of directions
    const double r = 0.05 * std::sqrt(random.uniform(0, 1));
    const double phi = random.uniform(0, 2 * std::numbers::pi);
    x = {r * std::cos(phi), 0, r * std::sin(phi)};

    const double up = random.uniform(std::cos(spread), 1);
    const double side = std::sqrt(1 - up * up);
    const double psi = random.uniform(0, 2 * std::numbers::pi);
    const double slower = std::sqrt(random.uniform(0.7, 1));
    v = slower * speed * glm::dvec3(side * std::cos(psi), up, side * std::sin(psi));
  }
  return starts;
}

MeshData stand_on_ground(MeshData mesh) {
  glm::vec3 low = mesh.positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }

  const glm::vec3 size = high - low;
  const float scale = k_size / std::max({size.x, size.y, size.z});
  const glm::vec3 foot{(low.x + high.x) / 2, low.y, (low.z + high.z) / 2};
  for (glm::vec3& p : mesh.positions) p = scale * (p - foot);
  return mesh;
}

std::vector<exact::Motion> emit_from_mesh(std::size_t n, double speed,
                                          const MeshData& mesh) {
  // Area up to and including each triangle, so that a random area finds its triangle
  std::vector<double> area_until;
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = triangle(mesh, i);
    area += glm::length(glm::cross(b - a, c - a)) / 2;
    area_until.push_back(area);
  }
  if (!(area > 0)) throw InputError("the mesh has no area to emit from");

  Random random(k_seed);
  std::vector<exact::Motion> starts(n);
  for (auto& [x, v] : starts) {
    const auto found = std::ranges::upper_bound(area_until, random.uniform(0, area));
    const auto index =
        std::min<std::size_t>(static_cast<std::size_t>(found - area_until.begin()),
                              mesh.triangles.size() - 1);
    const auto [a, b, c] = triangle(mesh, index);

    // Evenly over the triangle, away from the surface
    const double s = std::sqrt(random.uniform(0, 1));
    const double t = random.uniform(0, 1);
    x = (1 - s) * a + s * (1 - t) * b + s * t * c;
    v = speed * glm::normalize(glm::cross(b - a, c - a));
  }
  return starts;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_01
