#include "common/physics/mesh_mass.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <compare>
#include <numeric>
#include <type_traits>
#include <utility>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// For sums whose terms cancel
using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using WideVec3 = glm::vec<3, Wide>;
using WideMat3 = glm::mat<3, 3, Wide>;

using Vertices = std::span<const Vec3>;
using Triangles = std::span<const Triangle>;

// Of the box around all triangles
WideVec3 middle(Vertices vertices, Triangles triangles) {
  Vec3 low = vertices[triangles.front()[0]], high = low;
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t i : triangle) {
      low = glm::min(low, vertices[i]);
      high = glm::max(high, vertices[i]);
    }
  }
  return (WideVec3(low) + WideVec3(high)) / Wide(2);
}

// Integrals of 1, r and r r^T over a body, r from `middle`
struct Integrals {
  WideVec3 middle;
  Wide one = 0;
  WideVec3 r{0};
  WideMat3 rr{0};
};

Integrals integrals(Vertices vertices, Triangles triangles) {
  Integrals sum{.middle = middle(vertices, triangles)};
  for (const auto& [i, j, k] : triangles) {
    const WideVec3 a = WideVec3(vertices[i]) - sum.middle;
    const WideVec3 b = WideVec3(vertices[j]) - sum.middle;
    const WideVec3 c = WideVec3(vertices[k]) - sum.middle;

    // (3.10) The tetrahedron between the middle and a triangle, negative where the
    // triangle shows its back: what lies outside the body cancels
    const Wide V = glm::dot(a, glm::cross(b, c)) / 6;
    const WideVec3 s = a + b + c;
    sum.one += V;
    sum.r += V / 4 * s;
    sum.rr += V / 20
              * (glm::outerProduct(a, a) + glm::outerProduct(b, b)
                 + glm::outerProduct(c, c) + glm::outerProduct(s, s));
  }
  return sum;
}

Wide area(Vertices vertices, const Triangle& triangle) {
  const WideVec3 a(vertices[triangle[0]]);
  const WideVec3 b(vertices[triangle[1]]);
  const WideVec3 c(vertices[triangle[2]]);
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

// "1 edge", "2 edges"
std::string counted(std::size_t n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

// For each vertex, the first of those at the same place
std::vector<std::uint32_t> welded(Vertices vertices) {
  const auto place = [&](std::uint32_t i) {
    return std::array{vertices[i].x, vertices[i].y, vertices[i].z};
  };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, place);

  std::vector<std::uint32_t> first = order;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const bool again = n > 0 && place(order[n]) == place(order[n - 1]);
    first[order[n]] = again ? first[order[n - 1]] : order[n];
  }
  return first;
}

// A side of a triangle, which may go along it upwards or downwards
struct Edge {
  std::uint32_t low, high;
  bool upwards;
  auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> sorted_edges(Vertices vertices, Triangles triangles) {
  const std::vector<std::uint32_t> vertex = welded(vertices);
  std::vector<Edge> edges;
  for (const auto& [i, j, k] : triangles) {
    for (const auto& [from, to] : {std::pair{i, j}, {j, k}, {k, i}}) {
      const auto [low, high] = std::minmax(vertex[from], vertex[to]);
      edges.push_back({low, high, vertex[from] == low});
    }
  }
  std::ranges::sort(edges);
  return edges;
}

std::string edge_fault(Vertices vertices, Triangles triangles) {
  const std::vector<Edge> edges = sorted_edges(vertices, triangles);
  std::size_t boundary = 0, crowded = 0, opposed = 0;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(edge, edges.end(), [&](const Edge& other) {
      return other.low != edge->low || other.high != edge->high;
    });
    boundary += next - edge == 1;
    crowded += next - edge > 2;
    opposed += next - edge == 2 && edge[0].upwards == edge[1].upwards;
    edge = next;
  }
  if (boundary > 0) return "not closed: " + counted(boundary, "boundary edge");
  if (crowded > 0) return counted(crowded, "edge") + " with more than two triangles";
  if (opposed > 0) return counted(opposed, "edge") + " between opposite windings";
  return "";
}

std::string vertex_fault(Vertices vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (const Real x : {vertices[i].x, vertices[i].y, vertices[i].z})
      if (!std::isfinite(x)) return "vertex " + std::to_string(i) + " is not finite";
  return "";
}

std::string index_fault(Vertices vertices, Triangles triangles) {
  for (const Triangle& triangle : triangles) {
    const std::uint32_t i = std::ranges::max(triangle);
    if (i >= vertices.size())
      return "index " + std::to_string(i) + " is out of range, there are "
             + std::to_string(vertices.size()) + " vertices";
  }
  return "";
}

std::string area_fault(Vertices vertices, Triangles triangles) {
  const auto flat = std::ranges::count_if(
      triangles, [&](const Triangle& t) { return area(vertices, t) == 0; });
  if (flat == 0) return "";
  return counted(std::size_t(flat), "triangle") + " without area";
}

std::string volume_fault(Vertices vertices, Triangles triangles) {
  const Integrals body = integrals(vertices, triangles);
  Wide reach = 0;
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t i : triangle)
      reach = std::max(reach, glm::distance(WideVec3(vertices[i]), body.middle));

  // What rounding in double may make of nothing
  const Wide nothing = Wide(triangles.size()) * Wide(0x1p-52) * reach * reach * reach;
  if (std::abs(body.one) <= nothing) return "no volume";
  if (body.one > 0) return "";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), double(body.one),
                                 std::chars_format::general, 3);
  return "inside out: volume " + std::string(digits.begin(), end.ptr) + " m³";
}

}  // namespace

std::string mesh_fault(Vertices vertices, Triangles triangles) {
  if (triangles.empty()) return "no triangles";
  std::string fault = vertex_fault(vertices);
  for (const auto find : {index_fault, area_fault, edge_fault, volume_fault})
    if (fault.empty()) fault = find(vertices, triangles);
  return fault;
}

std::vector<Triangle> flipped(Triangles triangles) {
  std::vector<Triangle> other;
  for (const auto& [i, j, k] : triangles) other.push_back({i, k, j});
  return other;
}

Real mesh_volume(Vertices vertices, Triangles triangles) {
  return Real(integrals(vertices, triangles).one);
}

Real surface_area(Vertices vertices, Triangles triangles) {
  Wide sum = 0;
  for (const Triangle& triangle : triangles) sum += area(vertices, triangle);
  return Real(sum);
}

MassProperties mesh_mass(Real density, Vertices vertices, Triangles triangles) {
  const auto [middle, volume, r, rr] = integrals(vertices, triangles);

  // (3.6) Where the centre is, and r r^T about it
  const WideVec3 d = r / volume;
  const WideMat3 C = rr - volume * glm::outerProduct(d, d);

  // (3.7) |r|^2 is the trace of r r^T
  const Wide trace = C[0][0] + C[1][1] + C[2][2];
  return {Real(density * volume), Vec3(middle + d),
          Mat3(Wide(density) * (trace * WideMat3(1) - C))};
}

}  // namespace timestep::inline TIMESTEP_PRECISION
