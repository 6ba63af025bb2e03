#include "common/physics/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "common/physics/quickhull.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Index = std::uint32_t;
using Indices = std::vector<Index>;
using DVec3 = glm::dvec3;

constexpr Index k_none = std::numeric_limits<Index>::max();

// A side of a triangle: the one that starts at its vertex `corner`
struct Side {
  Index triangle, corner;
  bool operator==(const Side&) const = default;
};

Index origin(const TriangleHull& hull, Side side) {
  return hull.triangles[side.triangle][side.corner];
}

Side next(Side side) {
  return {side.triangle, (side.corner + 1) % 3};
}

// The same edge as a side of the triangle beyond it
Side twin(const TriangleHull& hull, Side side) {
  const Index beyond = hull.neighbours[side.triangle][side.corner];
  const Index start = origin(hull, next(side));
  Index corner = 0;
  while (hull.triangles[beyond][corner] != start) ++corner;
  return {beyond, corner};
}

// Unit normal and a point: no point of the hull is above a triangle's plane
struct TrianglePlane {
  DVec3 normal, foot;
  double area;  // twice that of the triangle

  double height(const DVec3& p) const { return glm::dot(normal, p - foot); }
};

TrianglePlane plane_of(const TriangleHull& hull, Index triangle) {
  const auto [i, j, k] = hull.triangles[triangle];
  const DVec3& a = hull.points[i];
  const DVec3 n = accurate_normal(a, hull.points[j], hull.points[k]);
  const double area = glm::length(n);
  return {n / std::max(area, std::numeric_limits<double>::min()), a, area};
}

// Which triangles make one face: those with the same number, that of the one among them
// whose plane it is
struct Faces {
  Indices of_triangle;
  std::vector<TrianglePlane> planes;  // of the triangles
  Indices meeting;                    // how many faces meet at a point
};

Index face_beyond(const TriangleHull& hull, const Faces& faces, Side side) {
  return faces.of_triangle[hull.neighbours[side.triangle][side.corner]];
}

bool is_border(const TriangleHull& hull, const Faces& faces, Side side) {
  return face_beyond(hull, faces, side) != faces.of_triangle[side.triangle];
}

template <typename Visit>
void for_each_border(const TriangleHull& hull, const Faces& faces, Visit visit) {
  for (Index t = 0; t < hull.triangles.size(); ++t)
    for (Index corner = 0; corner < 3; ++corner)
      if (is_border(hull, faces, {t, corner})) visit(Side{t, corner});
}

void count_meeting(const TriangleHull& hull, Faces& faces) {
  faces.meeting.assign(hull.points.size(), 0);
  for_each_border(hull, faces, [&](Side side) { ++faces.meeting[origin(hull, side)]; });
}

// Every triangle a face
Faces separate_faces(const TriangleHull& hull) {
  Faces faces;
  for (Index t = 0; t < hull.triangles.size(); ++t) {
    faces.of_triangle.push_back(t);
    faces.planes.push_back(plane_of(hull, t));
  }
  count_meeting(hull, faces);
  return faces;
}

// The triangles around a seed with all vertices near its plane become one face with it
void flood(const TriangleHull& hull, Faces& faces, Index seed, double tolerance) {
  const TrianglePlane& plane = faces.planes[seed];
  const auto is_near = [&](Index i) {
    return std::abs(plane.height(hull.points[i])) <= tolerance;
  };
  Indices found{seed};
  faces.of_triangle[seed] = seed;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const Index t : hull.neighbours[found[i]]) {
      const bool free = faces.of_triangle[t] == k_none;
      if (!free || glm::dot(plane.normal, faces.planes[t].normal) < 0) continue;
      if (!std::ranges::all_of(hull.triangles[t], is_near)) continue;
      faces.of_triangle[t] = seed;
      found.push_back(t);
    }
  }
}

// Of the faces beside one, given its borders, that in whose plane it is best
Index heir(const TriangleHull& hull, const Faces& faces,
           const std::vector<Side>& borders) {
  Index best = k_none;
  double least = std::numeric_limits<double>::infinity();
  for (const Side& side : borders) {
    const Index face = face_beyond(hull, faces, side);
    double off = 0;
    for (const Side& other : borders) {
      const DVec3& p = hull.points[origin(hull, other)];
      off = std::max(off, std::abs(faces.planes[face].height(p)));
    }
    if (off < least) best = face;
    least = std::min(least, off);
  }
  return best;
}

// A face of fewer than three corners is a sliver between others, and goes to one of
// them; of two such, the later one to the earlier. Whether any went.
bool give_away_slivers(const TriangleHull& hull, Faces& faces) {
  const std::size_t n = hull.triangles.size();
  Indices corners(n, 0), goes_to(n, k_none);
  for_each_border(hull, faces, [&](Side side) {
    corners[faces.of_triangle[side.triangle]] +=
        Index(faces.meeting[origin(hull, side)] > 2);
  });
  std::map<Index, std::vector<Side>> slivers;
  for_each_border(hull, faces, [&](Side side) {
    const Index face = faces.of_triangle[side.triangle];
    if (corners[face] < 3) slivers[face].push_back(side);
  });

  bool changed = false;
  for (const auto& [face, borders] : slivers) {
    const Index other = heir(hull, faces, borders);
    if (corners[other] >= 3 || other < face) goes_to[face] = other;
  }
  for (Index& face : faces.of_triangle) {
    if (goes_to[face] == k_none) continue;
    face = goes_to[face];
    changed = true;
  }
  return changed;
}

Faces merged_faces(const TriangleHull& hull, double tolerance) {
  Faces faces = separate_faces(hull);

  // Large triangles know best where their plane is
  Indices seeds = faces.of_triangle;
  std::ranges::stable_sort(seeds, std::greater{},
                           [&](Index t) { return faces.planes[t].area; });
  std::ranges::fill(faces.of_triangle, k_none);
  for (const Index seed : seeds)
    if (faces.of_triangle[seed] == k_none) flood(hull, faces, seed, tolerance);

  do {
    count_meeting(hull, faces);
  } while (give_away_slivers(hull, faces));
  return faces;
}

// The next side along the border of its face
Side next(const TriangleHull& hull, const Faces& faces, Side side) {
  side = next(side);
  while (!is_border(hull, faces, side)) side = next(twin(hull, side));
  return side;
}

// A hull's polygons while they are put together
struct Polygons {
  std::vector<HalfEdge> half_edges;
  Indices face_start{0};
  std::vector<DVec3> normals;
  Indices half_edge_at;     // by the side that it starts with: 3 triangle + corner
  std::vector<Side> twins;  // the side that each half-edge's twin starts with
  std::size_t borders = 0;  // sides that are part of an outline
};

// Once around a face, counter-clockwise, from a corner of it on; where only two faces
// meet is none
void add_outline(const TriangleHull& hull, const Faces& faces, Side start,
                 Polygons& polygons) {
  const Index face = Index(polygons.face_start.size() - 1);
  Side side = start;
  do {
    if (faces.meeting[origin(hull, side)] > 2) {
      polygons.half_edge_at[3 * side.triangle + side.corner] =
          Index(polygons.half_edges.size());
      polygons.half_edges.push_back({origin(hull, side), 0, 0, face});
      polygons.twins.push_back(side);
    }
    polygons.twins.back() = twin(hull, side);
    ++polygons.borders;
    side = next(hull, faces, side);
  } while (side != start);
  polygons.face_start.push_back(Index(polygons.half_edges.size()));
}

Polygons polygons_of(const TriangleHull& hull, const Faces& faces) {
  Polygons polygons;
  polygons.half_edge_at.assign(3 * hull.triangles.size(), k_none);
  std::vector<bool> done(hull.triangles.size(), false);
  for_each_border(hull, faces, [&](Side side) {
    const Index face = faces.of_triangle[side.triangle];
    if (done[face] || faces.meeting[origin(hull, side)] < 3) return;
    done[face] = true;
    add_outline(hull, faces, side, polygons);
    polygons.normals.push_back(faces.planes[face].normal);
  });
  return polygons;
}

// Whether merging left one outline around each face, and a sphere of them all
bool is_polyhedron(const TriangleHull& hull, const Faces& faces,
                   const Polygons& polygons) {
  std::size_t borders = 0;
  for_each_border(hull, faces, [&](Side) { ++borders; });
  const auto corners =
      std::ranges::count_if(faces.meeting, [](Index n) { return n > 2; });
  const std::size_t F = polygons.normals.size();
  const std::size_t E = polygons.half_edges.size() / 2;
  return borders == polygons.borders && std::size_t(corners) + F == E + 2;
}

// Numbers the corners in the order of the points, and ties the half-edges together
void take_over(ConvexHull& result, const Faces& faces, const Polygons& polygons,
               std::span<const Vec3> points) {
  Indices number(points.size(), k_none);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (faces.meeting[i] < 3) continue;
    number[i] = Index(result.vertices.size());
    result.vertices.push_back(points[i]);
  }
  result.half_edges = polygons.half_edges;
  result.face_start = polygons.face_start;
  for (Index e = 0; e < result.half_edges.size(); ++e) {
    HalfEdge& edge = result.half_edges[e];
    const Side twin = polygons.twins[e];
    edge.origin = number[edge.origin];
    edge.twin = polygons.half_edge_at[3 * twin.triangle + twin.corner];
    const bool last = e + 1 == result.face_start[edge.face + 1];
    edge.next = last ? result.face_start[edge.face] : e + 1;
  }
}

// Around each vertex, from face to face
void find_neighbours(ConvexHull& hull) {
  const std::vector<HalfEdge>& edges = hull.half_edges;
  hull.vertex_edge.assign(hull.vertices.size(), k_none);
  for (Index e = 0; e < edges.size(); ++e)
    if (hull.vertex_edge[edges[e].origin] == k_none)
      hull.vertex_edge[edges[e].origin] = e;

  hull.first_neighbour.push_back(0);
  for (const Index first : hull.vertex_edge) {
    Index e = first;
    do {
      hull.neighbours.push_back(edges[edges[e].twin].origin);
      e = edges[edges[e].twin].next;
    } while (e != first);
    hull.first_neighbour.push_back(Index(hull.neighbours.size()));
  }
}

// Where to climb from: only the way there gets shorter, not another support vertex
void find_starts(ConvexHull& hull) {
  const HullShape shape = hull_shape(hull);
  std::vector<Index> starts;
  for (std::size_t cell = 0; cell < k_cells * k_cells * k_cells; ++cell)
    starts.push_back(support_vertex(shape, middle_of_cell(cell), 0));
  hull.starts = starts;
}

void find_planes(ConvexHull& hull, const std::vector<DVec3>& normals) {
  const HullShape shape = hull_shape(hull);
  for (Index f = 0; f < normals.size(); ++f) {
    const Vec3 normal(normals[f]);
    const Index start = hull.half_edges[hull.face_start[f]].origin;
    const Index top = support_vertex(shape, normal, start);
    hull.planes.push_back({normal, glm::dot(normal, hull.vertices[top])});
  }
}

}  // namespace

HullResult convex_hull(std::span<const Vec3> points) {
  const TriangleHull triangles = quickhull(points);
  if (!triangles.fault.empty()) return {{}, triangles.fault};

  // Merge what is in one plane. Triangles are sure to fit together; rounding could tear
  // faces apart, though no cloud is known that they tear with
  const double tolerance = std::min(16 * triangles.rounding, triangles.thickness / 64);
  Faces faces = merged_faces(triangles, tolerance);
  Polygons polygons = polygons_of(triangles, faces);
  if (!is_polyhedron(triangles, faces, polygons)) {
    faces = separate_faces(triangles);
    polygons = polygons_of(triangles, faces);
  }

  // Build the polyhedron
  ConvexHull hull;
  take_over(hull, faces, polygons, points);
  find_neighbours(hull);
  find_starts(hull);
  find_planes(hull, polygons.normals);
  for (const Vec3& v : hull.vertices)
    hull.reach = std::max(hull.reach, std::hypot(v.x, v.y, v.z));
  hull.volume = mesh_volume(hull.vertices, hull_triangles(hull));
  return {hull, ""};
}

HullShape hull_shape(const ConvexHull& hull) {
  return {.vertices = hull.vertices,
          .first_neighbour = hull.first_neighbour,
          .neighbours = hull.neighbours,
          .starts = hull.starts,
          .volume = hull.volume,
          .reach = hull.reach,
          .hull = &hull};
}

std::vector<Triangle> hull_triangles(const ConvexHull& hull) {
  std::vector<Triangle> triangles;
  for (std::size_t f = 0; f < hull.planes.size(); ++f) {
    const Index first = hull.face_start[f];
    for (Index e = first + 1; e + 1 < hull.face_start[f + 1]; ++e)
      triangles.push_back({hull.half_edges[first].origin, hull.half_edges[e].origin,
                           hull.half_edges[e + 1].origin});
  }
  return triangles;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
