#include "common/physics/quickhull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Index = std::uint32_t;
using DVec3 = glm::dvec3;

constexpr Index k_none = std::numeric_limits<Index>::max();
constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;

// A triangle of the hull so far, with the points that are above it
struct Facet {
  Triangle vertices;
  Triangle neighbours;
  DVec3 normal;  // as long as twice its area
  Index outside = k_none, furthest = k_none;
  double height = 0;  // of the furthest, times the length of the normal
  bool gone = false;
};

struct Quickhull {
  std::vector<DVec3> points;
  std::vector<Facet> facets;
  std::vector<Index> next_outside;  // above the same facet, a list for each
  std::vector<Index> fan;           // the new facet beside the horizon, by its start
};

std::string point_fault(std::span<const Vec3> points) {
  if (points.empty()) return "no points";
  if (points.size() >= 0x80000000U) return "too many points";
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Real x : {points[i].x, points[i].y, points[i].z})
      if (!std::isfinite(x)) return "point " + std::to_string(i) + " is not finite";
  return "";
}

// Coordinates below 2^-200 of the largest count as 0: see side_of_plane
std::vector<DVec3> scaled(std::span<const Vec3> points) {
  double largest = std::numeric_limits<double>::min();
  for (const Vec3& p : points)
    largest = std::max(
        {largest, double(std::abs(p.x)), double(std::abs(p.y)), double(std::abs(p.z))});
  const int exponent = std::ilogb(largest);
  const auto scaled_one = [&](Real x) {
    const double y = std::ldexp(double(x), -exponent);
    return std::abs(y) < 0x1p-200 ? 0 : y;
  };
  std::vector<DVec3> result;
  result.reserve(points.size());
  for (const Vec3& p : points)
    result.emplace_back(scaled_one(p.x), scaled_one(p.y), scaled_one(p.z));
  return result;
}

// The index of the point for which `size` is largest, the first of several
template <typename Size>
Index largest(const std::vector<DVec3>& points, Size size) {
  Index best = 0;
  double most = size(points[0]);
  for (Index i = 1; i < points.size(); ++i) {
    const double x = size(points[i]);
    if (x > most) best = i;
    most = std::max(most, x);
  }
  return best;
}

// Two points that are as far apart as two of the cloud's outermost along x, y, z
std::array<Index, 2> longest_line(const std::vector<DVec3>& points) {
  std::array<Index, 2> line{0, 0};
  for (glm::length_t i = 0; i < 3; ++i) {
    const Index low = largest(points, [&](const DVec3& p) { return -p[i]; });
    const Index high = largest(points, [&](const DVec3& p) { return p[i]; });
    if (glm::distance(points[low], points[high])
        > glm::distance(points[line[0]], points[line[1]]))
      line = {low, high};
  }
  return line;
}

// A tetrahedron that is long, then wide, then high; sets the hull's thickness and fault
std::array<Index, 4> first_tetrahedron(TriangleHull& hull) {
  const std::vector<DVec3>& p = hull.points;
  const double nothing = 8 * hull.rounding;
  const std::array<Index, 2> line = longest_line(p);
  const Index a = line[0], b = line[1];
  const DVec3 along = p[b] - p[a];
  if (glm::length(along) <= nothing) hull.fault = "all points coincide";
  if (!hull.fault.empty()) return {};

  const auto off_line = [&](const DVec3& x) {
    return glm::length(accurate_normal(p[a], p[b], x)) / glm::length(along);
  };
  const Index c = largest(p, off_line);
  if (off_line(p[c]) <= nothing) hull.fault = "all points are on a line";
  if (!hull.fault.empty()) return {};

  const DVec3 n = glm::normalize(accurate_normal(p[a], p[b], p[c]));
  const auto off_plane = [&](const DVec3& x) {
    return std::abs(glm::dot(n, x - p[a]));
  };
  const Index d = largest(p, off_plane);
  hull.thickness = off_plane(p[d]);
  const int side = side_of_plane(p[a], p[b], p[c], p[d]);
  if (hull.thickness <= nothing || side == 0) hull.fault = "all points are in a plane";
  return side < 0 ? std::array{a, b, c, d} : std::array{a, c, b, d};
}

Index add_facet(Quickhull& q, Index a, Index b, Index c) {
  const DVec3 normal = accurate_normal(q.points[a], q.points[b], q.points[c]);
  q.facets.push_back({.vertices = {a, b, c}, .neighbours = {}, .normal = normal});
  return Index(q.facets.size() - 1);
}

bool is_above(const Quickhull& q, const Facet& facet, Index point) {
  const auto [a, b, c] = facet.vertices;
  return side_of_plane(q.points[a], q.points[b], q.points[c], q.points[point]) > 0;
}

// To the first facet from `first` on that has the point above it, if there is one
void assign(Quickhull& q, Index point, Index first) {
  for (Index f = first; f < q.facets.size(); ++f) {
    Facet& facet = q.facets[f];
    if (!is_above(q, facet, point)) continue;
    const DVec3 from_facet = q.points[point] - q.points[facet.vertices[0]];
    const double height = glm::dot(facet.normal, from_facet);
    if (facet.furthest == k_none || height > facet.height) {
      facet.furthest = point;
      facet.height = height;
    }
    q.next_outside[point] = facet.outside;
    facet.outside = point;
    return;
  }
}

// All facets that a point is above, from one of them on; they are gone
std::vector<Index> take_visible(Quickhull& q, Index facet, Index eye) {
  std::vector<Index> visible{facet};
  q.facets[facet].gone = true;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    for (const Index f : q.facets[visible[i]].neighbours) {
      if (q.facets[f].gone || !is_above(q, q.facets[f], eye)) continue;
      q.facets[f].gone = true;
      visible.push_back(f);
    }
  }
  return visible;
}

Index& neighbour_at(Facet& facet, Index vertex) {
  std::size_t place = 0;
  while (facet.vertices[place] != vertex) ++place;
  return facet.neighbours[place];
}

// Facets from every side of the horizon, the rim of what is gone, to the eye
void add_fan(Quickhull& q, const std::vector<Index>& visible, Index eye) {
  const Index first = Index(q.facets.size());
  for (const Index v : visible) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index beyond = q.facets[v].neighbours[i];
      if (q.facets[beyond].gone) continue;
      const Index a = q.facets[v].vertices[i], b = q.facets[v].vertices[(i + 1) % 3];
      const Index facet = add_facet(q, a, b, eye);
      q.facets[facet].neighbours[0] = beyond;
      neighbour_at(q.facets[beyond], b) = facet;
      q.fan[a] = facet;
    }
  }
  for (Index facet = first; facet < q.facets.size(); ++facet) {
    const Index next = q.fan[q.facets[facet].vertices[1]];
    q.facets[facet].neighbours[1] = next;
    q.facets[next].neighbours[2] = facet;
  }
}

// Pulls the hull out to the furthest of the points above a facet
void grow(Quickhull& q, Index facet) {
  const Index eye = q.facets[facet].furthest;
  const std::vector<Index> visible = take_visible(q, facet, eye);
  const Index first_new = Index(q.facets.size());
  add_fan(q, visible, eye);

  // What was above a lost facet and is above no new one is inside from now on
  for (const Index v : visible) {
    Index point = q.facets[v].outside;
    while (point != k_none) {
      const Index next = q.next_outside[point];
      if (point != eye) assign(q, point, first_new);
      point = next;
    }
  }
}

Quickhull start(const std::vector<DVec3>& points,
                const std::array<Index, 4>& tetrahedron) {
  const std::size_t n = points.size();
  Quickhull q{.points = points,
              .facets = {},
              .next_outside = std::vector<Index>(n, k_none),
              .fan = std::vector<Index>(n, k_none)};
  const auto [a, b, c, d] = tetrahedron;
  for (const auto& [i, j, k] : {Triangle{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}})
    add_facet(q, i, j, k);
  q.facets[0].neighbours = {1, 2, 3};
  q.facets[1].neighbours = {3, 2, 0};
  q.facets[2].neighbours = {1, 3, 0};
  q.facets[3].neighbours = {2, 1, 0};
  for (Index i = 0; i < n; ++i) assign(q, i, 0);
  return q;
}

// The facets that are left, numbered anew
void take_over(TriangleHull& hull, const Quickhull& q) {
  std::vector<Index> number(q.facets.size(), k_none);
  Index count = 0;
  for (std::size_t f = 0; f < q.facets.size(); ++f)
    if (!q.facets[f].gone) number[f] = count++;
  for (const Facet& facet : q.facets) {
    if (facet.gone) continue;
    const auto [a, b, c] = facet.neighbours;
    hull.triangles.push_back(facet.vertices);
    hull.neighbours.push_back({number[a], number[b], number[c]});
  }
}

}  // namespace

TriangleHull quickhull(std::span<const Vec3> points) {
  TriangleHull hull;
  hull.fault = point_fault(points);
  if (!hull.fault.empty()) return hull;

  // Begin with a tetrahedron
  hull.points = scaled(points);
  double reach = 0;
  for (const DVec3& p : hull.points)
    reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  hull.rounding = k_u * reach;
  const std::array<Index, 4> tetrahedron = first_tetrahedron(hull);
  if (!hull.fault.empty()) return hull;

  // As long as there are points above a facet, grow
  Quickhull q = start(hull.points, tetrahedron);
  for (Index f = 0; f < q.facets.size(); ++f)
    if (!q.facets[f].gone && q.facets[f].outside != k_none) grow(q, f);
  take_over(hull, q);
  return hull;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
