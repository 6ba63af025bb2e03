#include "common/physics/polytope.hpp"

#include <algorithm>
#include <limits>

#include "common/physics/simplex.hpp"

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Index = std::int16_t;

PolytopeFace& face_at(Polytope& polytope, Index face) {
  return polytope.faces[std::size_t(face)];
}

Index add_vertex(Polytope& polytope, const SupportPoint& point) {
  polytope.vertices[std::size_t(polytope.vertex_count)] = point;
  return Index(polytope.vertex_count++);
}

// Without neighbours yet. One without area is behind every point and never the closest
void make_face(Polytope& polytope, Index slot, Index i, Index j, Index k) {
  const Vec3& p = polytope.vertices[std::size_t(i)].w;
  const Vec3& q = polytope.vertices[std::size_t(j)].w;
  const Vec3& r = polytope.vertices[std::size_t(k)].w;
  const Vec3 n = area_normal(p, q, r);
  const Real size = glm::length(n);
  PolytopeFace& face = face_at(polytope, slot);
  face.vertices = {i, j, k};
  face.visible = false;
  face.final = !(size > 0);
  face.normal = face.final ? Vec3(0) : n * (1 / size);
  face.offset = glm::dot(face.normal, p);
}

// An edge between a face that the new vertex sees and one that it does not
struct HorizonEdge {
  Index from, to;
  Index beyond;  // the face that stays
};

struct Horizon {
  std::array<HorizonEdge, k_polytope_faces> edges;
  std::array<Index, k_polytope_faces> visible;  // faces
  int edge_count = 0, visible_count = 0;
};

// The faces that w is in front of, from the first one on, and their outer edges.
// A face in whose plane w lies goes, too: no triangle without area comes of it
void find_horizon(Polytope& polytope, Index first, const Vec3& w, Horizon& horizon) {
  face_at(polytope, first).visible = true;
  horizon.visible[0] = first;
  horizon.visible_count = 1;
  for (int done = 0; done < horizon.visible_count; ++done) {
    const Index current = horizon.visible[std::size_t(done)];
    for (const Index n : face_at(polytope, current).neighbours) {
      PolytopeFace& next = face_at(polytope, n);
      if (next.visible || glm::dot(next.normal, w) - next.offset < -k_rounding / 4)
        continue;
      next.visible = true;
      horizon.visible[std::size_t(horizon.visible_count++)] = n;
    }
  }
  for (int i = 0; i < horizon.visible_count; ++i) {
    const PolytopeFace& face = face_at(polytope, horizon.visible[std::size_t(i)]);
    for (std::size_t e = 0; e < 3; ++e) {
      if (face_at(polytope, face.neighbours[e]).visible) continue;
      horizon.edges[std::size_t(horizon.edge_count++)] = {
          face.vertices[e], face.vertices[(e + 1) % 3], face.neighbours[e]};
    }
  }
}

// Brings the edges into the order in which one ends where the next begins; false if
// they are not one loop
bool order(Horizon& horizon) {
  const std::size_t n = std::size_t(horizon.edge_count);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    std::size_t next = i + 1;
    while (next < n && horizon.edges[next].from != horizon.edges[i].to) ++next;
    if (next == n) return false;
    std::swap(horizon.edges[i + 1], horizon.edges[next]);
  }
  return n >= 3 && horizon.edges[n - 1].to == horizon.edges[0].from;
}

void connect(PolytopeFace& face, Index from, Index neighbour) {
  for (std::size_t e = 0; e < 3; ++e)
    if (face.vertices[e] == from) face.neighbours[e] = neighbour;
}

// Fills the hole within the horizon with a fan of triangles about the new vertex
void close(Polytope& polytope, const Horizon& horizon, Index vertex) {
  const int n = horizon.edge_count;
  std::array<Index, k_polytope_faces> slots;
  for (int i = 0; i < n; ++i)
    slots[std::size_t(i)] = i < horizon.visible_count ? horizon.visible[std::size_t(i)]
                                                      : Index(polytope.face_count++);
  for (int i = 0; i < n; ++i) {
    const HorizonEdge& edge = horizon.edges[std::size_t(i)];
    const Index slot = slots[std::size_t(i)];
    make_face(polytope, slot, edge.from, edge.to, vertex);
    face_at(polytope, slot).neighbours = {edge.beyond, slots[std::size_t((i + 1) % n)],
                                          slots[std::size_t((i + n - 1) % n)]};
    connect(face_at(polytope, edge.beyond), edge.to, slot);
  }
}

}  // namespace

void make_tetrahedron(Polytope& polytope, const std::array<SupportPoint, 4>& points) {
  // The fourth point is behind the first face
  for (const SupportPoint& p : points) add_vertex(polytope, p);
  const Vec3 p = points[0].w;
  const Vec3 n = area_normal(p, points[1].w, points[2].w);
  if (glm::dot(n, points[3].w - p) > 0)
    std::swap(polytope.vertices[0], polytope.vertices[1]);
  make_face(polytope, 0, 0, 1, 2);
  make_face(polytope, 1, 0, 3, 1);
  make_face(polytope, 2, 1, 3, 2);
  make_face(polytope, 3, 2, 3, 0);

  // Beyond the edges from each face's first, second and third vertex
  polytope.faces[0].neighbours = {1, 2, 3};
  polytope.faces[1].neighbours = {3, 2, 0};
  polytope.faces[2].neighbours = {1, 3, 0};
  polytope.faces[3].neighbours = {2, 1, 0};
  polytope.face_count = 4;
}

int closest_face(const Polytope& polytope) {
  int closest = -1;
  Real least = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < polytope.face_count; ++i) {
    const PolytopeFace& face = polytope.faces[std::size_t(i)];
    if (face.final || !(face.offset < least)) continue;
    closest = i;
    least = face.offset;
  }
  return closest;
}

bool has_vertex(const Polytope& polytope, const Vec3& w) {
  return std::any_of(polytope.vertices.begin(),
                     polytope.vertices.begin() + polytope.vertex_count,
                     [&](const SupportPoint& p) { return p.w == w; });
}

bool expand(Polytope& polytope, int face, const SupportPoint& point) {
  Horizon horizon;
  find_horizon(polytope, Index(face), point.w, horizon);
  const bool sound = order(horizon);
  for (int i = 0; i < horizon.visible_count; ++i) {
    PolytopeFace& seen = face_at(polytope, horizon.visible[std::size_t(i)]);
    seen.visible = false;
    seen.final = seen.final || sound;
  }
  if (sound) close(polytope, horizon, add_vertex(polytope, point));
  return sound;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
