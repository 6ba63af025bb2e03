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

std::vector<exact::Motion> emit_from_jets(std::size_t n, double speed, double lean) {
  constexpr std::size_t k_middle =
      4;                              // of 16 droplets in turn, those of the middle jet
  constexpr std::size_t k_ring = 12;  // jets around it
  Random random(k_seed);
  std::vector<exact::Motion> starts(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t turn = i % (k_middle + k_ring);
    const bool middle = turn < k_middle;
    const double around = 2 * std::numbers::pi * static_cast<double>(turn) / k_ring;
    const glm::dvec3 outwards{std::cos(around), 0, std::sin(around)};

    // No jet is perfect: up to 2 % off its direction, up to 3 % slower
    const double tilt = middle ? 0 : lean;
    const glm::dvec3 direction =
        std::sin(tilt) * outwards + glm::dvec3(0, std::cos(tilt), 0)
        + glm::dvec3(random.uniform(-0.02, 0.02), 0, random.uniform(-0.02, 0.02));
    starts[i].x = (middle ? 0.0 : 0.3) * outwards;
    starts[i].v = speed * random.uniform(0.97, 1) * glm::normalize(direction);
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
  if (!(area > 0)) throw InputError("--mesh: its triangles have no area to emit from");

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
