#include "common/physics/decomposition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

// Triangles by their corners
using Surface = std::vector<std::array<Vec3, 3>>;

// What of the mesh is in a box along the axes
struct Piece {
  Surface surface;
  Vec3 low{0}, high{0};  // corners of the box
  ConvexHull hull;       // empty if the piece is flat
};

// The two halves of a piece, and the volume that is in its hull and in none of theirs
struct Cut {
  Piece below, above;
  Real gain = 0;
};

// How much of the sphere around a point a triangle covers, negative from behind [sr].
// Source: A. van Oosterom, J. Strackee, The solid angle of a plane triangle, 1983.
Real solid_angle(const std::array<Vec3, 3>& triangle, const Vec3& from) {
  const Vec3 a = triangle[0] - from, b = triangle[1] - from, c = triangle[2] - from;
  const Real la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const Real volume = glm::dot(a, glm::cross(b, c));
  return 2
         * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la
                                  + glm::dot(c, a) * lb);
}

// (4.29) Inside, all 4 pi of the sphere is covered; on the surface, less. What is on
// the surface needs no more points than the surface has.
bool is_inside(const Surface& mesh, const Vec3& point) {
  Real covered = 0;
  for (const auto& triangle : mesh) covered += solid_angle(triangle, point);
  return covered > Real(3.5 * std::numbers::pi);
}

// (4.26) The part of a triangle where side (x[axis] - at) <= 0, in triangles. One in
// the plane itself is a part of the half that it is the surface of.
void add_clipped(const std::array<Vec3, 3>& triangle, glm::length_t axis, Real at,
                 Real side, Surface& result) {
  const auto height = [&](const Vec3& p) { return side * (p[axis] - at); };
  const auto& [a, b, c] = triangle;
  const bool in_plane = height(a) == 0 && height(b) == 0 && height(c) == 0;
  if (in_plane && side * glm::cross(b - a, c - a)[axis] < 0) return;

  std::array<Vec3, 4> corners;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from = triangle[i], &to = triangle[(i + 1) % 3];
    const Real h = height(from), next_h = height(to);
    if (h <= 0) corners[n++] = from;
    if (std::min(h, next_h) >= 0 || std::max(h, next_h) <= 0) continue;
    corners[n] = from + h / (h - next_h) * (to - from);
    corners[n++][axis] = at;
  }
  for (std::size_t i = 2; i < n; ++i)
    result.push_back({corners[0], corners[i - 1], corners[i]});
}

// The hull of what is in the box: of the surface there, and of the corners of the box
// that are inside the mesh
void find_hull(Piece& piece, const Surface& mesh) {
  std::vector<Vec3> points;
  for (const auto& triangle : piece.surface)
    points.insert(points.end(), triangle.begin(), triangle.end());
  for (const Real x : {piece.low.x, piece.high.x})
    for (const Real y : {piece.low.y, piece.high.y})
      for (const Real z : {piece.low.z, piece.high.z})
        if (is_inside(mesh, {x, y, z})) points.emplace_back(x, y, z);

  // No more box than the piece needs
  piece.hull = convex_hull(points).hull;
  for (std::size_t i = 0; i < points.size(); ++i) {
    piece.low = i == 0 ? points[0] : glm::min(piece.low, points[i]);
    piece.high = i == 0 ? points[0] : glm::max(piece.high, points[i]);
  }
}

Cut cut(const Piece& piece, const Surface& mesh, glm::length_t axis, Real at) {
  Cut halves{
      .below = {.surface = {}, .low = piece.low, .high = piece.high, .hull = {}},
      .above = {.surface = {}, .low = piece.low, .high = piece.high, .hull = {}}};
  halves.below.high[axis] = halves.above.low[axis] = at;
  for (const auto& triangle : piece.surface) {
    add_clipped(triangle, axis, at, 1, halves.below.surface);
    add_clipped(triangle, axis, at, -1, halves.above.surface);
  }
  find_hull(halves.below, mesh);
  find_hull(halves.above, mesh);
  halves.gain = piece.hull.volume - halves.below.hull.volume - halves.above.hull.volume;
  return halves;
}

// Of some planes across each axis, the one that saves most
Cut best_cut(const Piece& piece, const Surface& mesh, int planes) {
  Cut best;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    for (int i = 1; i <= planes; ++i) {
      const Real share = Real(i) / Real(planes + 1);
      const Real at = piece.low[axis] + share * (piece.high[axis] - piece.low[axis]);
      Cut tried = cut(piece, mesh, axis, at);
      if (tried.gain > best.gain) best = std::move(tried);
    }
  }
  return best;
}

}  // namespace

Decomposition decompose(std::span<const Vec3> vertices,
                        std::span<const Triangle> triangles,
                        const DecompositionSettings& settings) {
  Decomposition result;
  result.fault = mesh_fault(vertices, triangles);
  if (!result.fault.empty()) return result;

  // The whole is the first piece
  Piece whole;
  for (const auto& [i, j, k] : triangles)
    whole.surface.push_back({vertices[i], vertices[j], vertices[k]});
  const Surface mesh = whole.surface;
  whole.low = whole.high = mesh[0][0];
  find_hull(whole, mesh);
  result.mesh_volume = mesh_volume(vertices, triangles);
  result.hull_volume = whole.hull.volume;

  // Cut where it saves most, as long as it saves enough
  std::vector<Piece> pieces{whole};
  std::vector<Cut> cuts{best_cut(whole, mesh, settings.cuts_per_axis)};
  while (pieces.size() < std::size_t(settings.parts)) {
    const auto best = std::ranges::max_element(cuts, {}, &Cut::gain);
    if (best->gain <= settings.least_gain * result.hull_volume) break;
    const auto i = best - cuts.begin();
    Cut halves = std::move(*best);
    cuts[std::size_t(i)] = best_cut(halves.below, mesh, settings.cuts_per_axis);
    cuts.push_back(best_cut(halves.above, mesh, settings.cuts_per_axis));
    pieces[std::size_t(i)] = std::move(halves.below);
    pieces.push_back(std::move(halves.above));
  }

  for (Piece& piece : pieces) {
    if (piece.hull.vertices.empty()) continue;
    result.parts_volume += piece.hull.volume;
    result.parts.push_back(std::move(piece.hull));
  }
  return result;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
