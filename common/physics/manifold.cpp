#include "common/physics/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

// Cosine of the angle to the normal up to which a face lies on another
constexpr Real k_lies_flat = Real(0.995);

// Near ties: areas that differ by less than a thousandth, depths by less than a
// hundredth
constexpr Real k_clearly_more = Real(1.001), k_near_depth = Real(0.01);

// A side of a face of A or of B
using SideName = std::uint32_t;
constexpr SideName k_of_b = 0x80000000U;

struct Corner {
  Vec3 point;
  SideName side;  // that leads on from here
};

// Clipping leaves a convex polygon one corner more at most. One that rounding has made
// a little concave may lose corners that there is no room for.
struct Polygon {
  std::array<Corner, 2 * k_face_capacity> corners;
  int count = 0;

  void add(const Vec3& point, SideName side) {
    if (std::size_t(count) == corners.size()) return;
    Corner& corner = corners[std::size_t(count++)];
    corner.point = point;
    corner.side = side;
  }
  const Corner& at(int i) const {
    return corners[std::size_t(i < count ? i : i - count)];
  }
};

// Candidates for contact points, with positions on the way along the normal
struct Candidates {
  std::array<ContactPoint, 2 * k_face_capacity + 1> points;
  int count = 0;

  void add(const Vec3& position, Real depth, std::uint64_t feature) {
    ContactPoint& point = points[std::size_t(count++)];
    point.position = position;
    point.depth = depth;
    point.feature = feature;
  }
  std::span<ContactPoint> all() { return {points.data(), std::size_t(count)}; }
};

void fill(const SupportingFace& face, SideName body, Polygon& polygon) {
  polygon.count = 0;
  for (std::size_t i = 0; i < std::size_t(face.count); ++i)
    polygon.add(face.corners[i], face.sides[i] | body);
}

// How far the corners of a polygon are above a plane, and whether any is
struct Heights {
  std::array<Real, 2 * k_face_capacity> of;
  bool any_above = false;
};

void measure(const Polygon& polygon, const Vec3& normal, Real offset,
             Heights& heights) {
  Real highest = 0;
  for (std::size_t i = 0; i < std::size_t(polygon.count); ++i) {
    heights.of[i] = glm::dot(normal, polygon.corners[i].point) - offset;
    highest = std::max(highest, heights.of[i]);
  }
  heights.any_above = highest > 0;
}

// (4.26) What of a polygon is not above a plane, by Sutherland and Hodgman
void clip(const Polygon& polygon, const Heights& heights, SideName side,
          Polygon& result) {
  result.count = 0;
  auto last = std::size_t(polygon.count) - 1;
  for (std::size_t i = 0; i < std::size_t(polygon.count); last = i++) {
    const Corner &from = polygon.corners[last], &to = polygon.corners[i];
    const Real h = heights.of[last], next_h = heights.of[i];

    // Leaving, go on along the plane; coming back, along the same side as before
    if ((h <= 0) != (next_h <= 0)) {
      const Vec3 crossing = from.point + (h / (h - next_h)) * (to.point - from.point);
      result.add(crossing, h <= 0 ? side : from.side);
    }
    if (next_h <= 0) result.add(to.point, to.side);
  }
}

// The names of the two sides that meet, whichever of them comes first
std::uint64_t feature(SideName a, SideName b) {
  const auto [low, high] = std::minmax(a, b);
  return std::uint64_t(high) << 32 | low;
}

// (4.25) The corners of what two faces share, seen along the normal, with the chords
// there that are no more apart than the margin. `across` is the normal from the
// reference face's side.
void add_chords(const SupportingFace& reference, SideName reference_body,
                const SupportingFace& incident, SideName incident_body,
                const Vec3& across, Real margin, Real slack, Candidates& found) {
  std::array<Polygon, 2> buffers;
  Polygon *shared = buffers.data(), *spare = shared + 1;
  fill(incident, incident_body, *shared);
  Heights heights;
  const auto sides = std::size_t(reference.is_boundless ? 0 : reference.count);
  for (std::size_t i = 0; i < sides; ++i) {
    const Vec3& from = reference.corners[i];
    const Vec3& to = reference.corners[i + 1 < sides ? i + 1 : 0];
    const Vec3 outwards = glm::cross(to - from, across);
    const Real offset = glm::dot(outwards, from) + slack * glm::length(outwards);
    measure(*shared, outwards, offset, heights);
    if (!heights.any_above) continue;
    clip(*shared, heights, reference.sides[i] | reference_body, *spare);
    std::swap(shared, spare);
  }

  const Vec3 down = reference.normal / -glm::dot(reference.normal, across);
  for (int i = 0; i < shared->count; ++i) {
    const Corner &corner = shared->at(i), &before = shared->at(i + shared->count - 1);
    const Real depth = glm::dot(down, corner.point - reference.corners[0]);
    if (depth >= -margin - slack)
      found.add(corner.point + depth / 2 * across, depth,
                feature(corner.side, before.side));
  }
}

// The first of the points that is as deep as the deepest, but for a near tie
const ContactPoint& deepest_of(std::span<const ContactPoint> points, Real slack) {
  const Real most = std::ranges::max_element(points, {}, &ContactPoint::depth)->depth;
  const Real enough = most - slack - k_near_depth * std::abs(most);
  return *std::ranges::find_if(
      points, [&](const ContactPoint& p) { return p.depth >= enough; });
}

// (4.27) The deepest point, and of all quadrangles (or triangles) with a corner there
// the largest: a diagonal, and the point furthest from it on either side
void keep_four(std::span<ContactPoint> points, Real slack, Manifold& manifold) {
  std::ranges::sort(points, {}, &ContactPoint::feature);
  const ContactPoint& first = deepest_of(points, slack);
  std::array<const ContactPoint*, 4> kept{&first, nullptr, nullptr, nullptr};
  Real most = 0;
  for (const ContactPoint& opposite : points) {
    const Vec3 diagonal = opposite.position - first.position;
    const Vec3 sideways = glm::cross(manifold.normal, diagonal);
    const ContactPoint *left = nullptr, *right = nullptr;
    Real furthest_left = 0, furthest_right = 0;
    for (const ContactPoint& p : points) {
      const Real x = glm::dot(sideways, p.position - first.position);
      if (x > furthest_left) left = &p;
      if (-x > furthest_right) right = &p;
      furthest_left = std::max(furthest_left, x);
      furthest_right = std::max(furthest_right, -x);
    }
    const Real area = furthest_left + furthest_right;
    if (area <= most * k_clearly_more) continue;
    most = area;
    kept = {&first, left, &opposite, right};
  }
  for (const ContactPoint* p : kept)
    if (p != nullptr) manifold.points[std::size_t(manifold.count++)] = *p;
}

// How far from the origin the farthest corner is
Real reach(const SupportingFace& a, const SupportingFace& b) {
  Real most = 0;
  for (const SupportingFace* face : {&a, &b})
    for (std::size_t i = 0; i < std::size_t(face->count); ++i)
      most = std::max(most, glm::dot(face->corners[i], face->corners[i]));
  return std::sqrt(most);
}

// What the faces share, if one lies flat on the other: that one tells the depth
void add_shared(const SupportingFace& a, const SupportingFace& b, const Vec3& normal,
                Real margin, Real slack, Candidates& found) {
  const Real slope_a = a.is_boundless ? 2 : glm::dot(a.normal, normal);
  const Real slope_b = b.is_boundless ? 2 : -glm::dot(b.normal, normal);
  const bool both = a.count > 0 && b.count > 0 && !(a.is_boundless && b.is_boundless);
  if (!both || std::max(slope_a, slope_b) < k_lies_flat) return;
  if (slope_a >= slope_b)
    add_chords(a, 0, b, k_of_b, normal, margin, slack, found);
  else
    add_chords(b, k_of_b, a, 0, -normal, margin, slack, found);
}

SideName side_name(std::size_t face, std::size_t side) {
  return SideName(4 * face + side);
}

// The face around the support vertex that faces the direction most. If none faces it
// well, one of the two beside the most level edge, which may be what touches.
std::uint32_t face_towards(const ConvexHull& hull, const Vec3& direction) {
  const std::uint32_t vertex = support_vertex(hull_shape(hull), direction, 0);
  const std::uint32_t start = hull.vertex_edge[vertex];
  std::uint32_t best = hull.half_edges[start].face, level = start;
  const auto slope = [&](std::uint32_t face) {
    return glm::dot(direction, hull.planes[face].normal);
  };
  Real least_drop = 2;
  std::uint32_t edge = start;
  do {
    const HalfEdge& e = hull.half_edges[edge];
    const std::uint32_t end = hull.half_edges[e.twin].origin;
    const Vec3 along = hull.vertices[end] - hull.vertices[vertex];
    const Real drop = std::abs(glm::dot(direction, along)) / glm::length(along);
    if (slope(e.face) > slope(best)) best = e.face;
    if (drop < least_drop) level = edge;
    least_drop = std::min(least_drop, drop);
    edge = hull.half_edges[e.twin].next;
  } while (edge != start);
  if (slope(best) >= k_lies_flat) return best;

  const std::uint32_t left = hull.half_edges[level].face;
  const std::uint32_t right = hull.half_edges[hull.half_edges[level].twin].face;
  return slope(left) >= slope(right) ? left : right;
}

}  // namespace

SupportingFace supporting_face(const Box& box, const Pose& pose,
                               const Vec3& direction) {
  const Mat3 R = matrix_of(pose.orientation);
  const Vec3 d = direction * R;
  glm::length_t axis = 0;
  for (const glm::length_t i : {1, 2})
    if (std::abs(d[i]) > std::abs(d[axis])) axis = i;
  const glm::length_t u = (axis + 1) % 3, v = (axis + 2) % 3;

  SupportingFace face;
  face.count = 4;
  const Real sign = std::copysign(Real(1), d[axis]);
  face.normal = sign * R[axis];
  const Vec3& half = box.half_extents;
  const Vec3 middle = pose.position + half[axis] * face.normal;
  const Vec3 along_u = sign * half[u] * R[u], along_v = half[v] * R[v];
  face.corners[0] = middle - along_u - along_v;
  face.corners[1] = middle + along_u - along_v;
  face.corners[2] = middle + along_u + along_v;
  face.corners[3] = middle - along_u + along_v;
  for (std::size_t i = 0; i < 4; ++i)
    face.sides[i] = side_name(2 * std::size_t(axis) + std::size_t(sign > 0), i);
  return face;
}

SupportingFace supporting_face(const ConvexHull& hull, const Pose& pose,
                               const Vec3& direction) {
  const Vec3 d = glm::normalize(direction_in_body(pose, direction));
  const std::uint32_t f = face_towards(hull, d), first = hull.face_start[f];

  // All corners, or as many as there is room for
  const std::uint32_t n = hull.face_start[f + 1] - first;
  const std::uint32_t count = std::min(n, std::uint32_t(k_face_capacity));
  SupportingFace face;
  face.count = int(count);
  face.normal = direction_in_world(pose, hull.planes[f].normal);
  for (std::uint32_t i = 0; i < count; ++i) {
    face.sides[i] = first + i * n / count;
    const HalfEdge& side = hull.half_edges[face.sides[i]];
    face.corners[i] = point_in_world(pose, hull.vertices[side.origin]);
  }
  return face;
}

SupportingFace supporting_face(const HalfSpace& plane, const Pose& pose, const Vec3&) {
  SupportingFace face;
  face.count = 1;
  face.normal = direction_in_world(pose, plane.normal);
  face.corners[0] = point_in_world(pose, plane.offset * plane.normal);
  face.is_boundless = true;
  return face;
}

SupportingFace supporting_face(const HullShape& view, const Pose& pose,
                               const Vec3& direction) {
  if (view.hull == nullptr) return {};
  return supporting_face(*view.hull, pose, direction);
}

SupportingFace supporting_face(const Shape& shape, const Pose& pose,
                               const Vec3& direction) {
  return std::visit([&](const auto& s) { return supporting_face(s, pose, direction); },
                    shape);
}

Manifold contact_manifold(const SupportingFace& a, const SupportingFace& b,
                          const Separation& separation, Real margin) {
  Manifold manifold;
  manifold.normal = separation.normal;
  const Real slack = 64 * k_u * reach(a, b);
  const Real depth = -separation.distance;
  if (depth < -margin - slack) return manifold;

  // The witness points, where no corner of the faces is as deep
  Candidates found;
  add_shared(a, b, manifold.normal, margin, slack, found);
  Real deepest = -std::numeric_limits<Real>::infinity();
  for (const ContactPoint& p : found.all()) deepest = std::max(deepest, p.depth);
  if (deepest < depth - slack - k_near_depth * std::abs(depth))
    found.add((separation.on_a + separation.on_b) / Real(2), depth, 0);

  if (found.count > 4) {
    keep_four(found.all(), slack, manifold);
  } else {
    std::ranges::copy(found.all(), manifold.points.begin());
    manifold.count = found.count;
  }
  return manifold;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
