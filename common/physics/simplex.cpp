#include "common/physics/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

using Wide = std::conditional_t<std::is_same_v<Real, float>, double, long double>;
using WideVec3 = glm::vec<3, Wide>;

Real squared(const Vec3& v) {
  return glm::dot(v, v);
}

// What rounding left of v along an edge that it is perpendicular to, taken away
Vec3 without(const Vec3& v, const Vec3& edge) {
  return v - (glm::dot(v, edge) / squared(edge)) * edge;
}

using Index = std::size_t;
using Vertices = std::array<SupportPoint, 4>;

ClosestPoint nearer(const ClosestPoint& a, const ClosestPoint& b) {
  return squared(b.point) < squared(a.point) ? b : a;
}

ClosestPoint closest_on_point(const Vertices& vertices, Index i) {
  ClosestPoint closest{vertices[i].w};
  closest.weights[i] = 1;
  return closest;
}

ClosestPoint closest_on_segment(const Vertices& vertices, Index i, Index j) {
  const Vec3 &p = vertices[i].w, &q = vertices[j].w;
  const Vec3 e = q - p;

  // Lengths from the foot of the perpendicular to either end, times |e|
  const Real from_p = -glm::dot(p, e), to_q = glm::dot(q, e);
  if (!(from_p > 0)) return closest_on_point(vertices, i);
  if (!(to_q > 0)) return closest_on_point(vertices, j);
  const Real t = from_p / (from_p + to_q);

  // From the nearer end
  const Vec3 foot = t < Real(0.5) ? p + t * e : q - (1 - t) * e;
  ClosestPoint closest{without(foot, e)};
  closest.weights[i] = 1 - t;
  closest.weights[j] = t;
  return closest;
}

// From the vertex nearest to the origin
Vec3 foot_on_plane(const Vec3& n, const Vec3& p, const Vec3& q, const Vec3& r) {
  Vec3 nearest = squared(q) < squared(p) ? q : p;
  if (squared(r) < squared(nearest)) nearest = r;
  return n * (glm::dot(n, nearest) / squared(n));
}

ClosestPoint closest_on_triangle(const Vertices& vertices, Index i, Index j, Index k) {
  const Vec3 &p = vertices[i].w, &q = vertices[j].w, &r = vertices[k].w;
  const Vec3 n = area_normal(p, q, r);
  const Vec3 foot = foot_on_plane(n, p, q, r);

  // Signed areas opposite to the vertices, times |n|
  const Vec3 fp = p - foot, fq = q - foot, fr = r - foot;
  const Real area_p = glm::dot(n, glm::cross(fq, fr));
  const Real area_q = glm::dot(n, glm::cross(fr, fp));
  const Real area_r = glm::dot(n, glm::cross(fp, fq));
  if (!(area_p > 0) || !(area_q > 0) || !(area_r > 0)) {
    ClosestPoint best = closest_on_point(vertices, i);
    if (!(area_p > 0)) best = nearer(best, closest_on_segment(vertices, j, k));
    if (!(area_q > 0)) best = nearer(best, closest_on_segment(vertices, k, i));
    if (!(area_r > 0)) best = nearer(best, closest_on_segment(vertices, i, j));
    return best;
  }
  ClosestPoint closest{foot};
  const Real whole = area_p + area_q + area_r;
  closest.weights[i] = area_p / whole;
  closest.weights[j] = area_q / whole;
  closest.weights[k] = area_r / whole;

  // The foot keeps its direction where it is next to the origin, but loses its length
  // where the triangle is a sliver; the weighted sum is in the triangle whatever
  // happens. What is wrong with that one is along the triangle: on to where it is
  // closest to the origin
  const Vec3 sum =
      closest.weights[i] * p + closest.weights[j] * q + closest.weights[k] * r;
  if (squared(sum - foot) > k_rounding * k_rounding / 64) {
    const Index end = squared(q - p) > squared(r - p) ? j : k;
    const Vec3 e = vertices[end].w - p;
    const Real step = std::clamp(-glm::dot(sum, e) / squared(e), -closest.weights[end],
                                 closest.weights[i]);
    closest.weights[i] -= step;
    closest.weights[end] += step;
    closest.point = sum + step * e;
  }
  return closest;
}

// On the faces opposite to the vertices that are marked
ClosestPoint closest_on_faces(const Vertices& vertices, const std::array<bool, 4>& marked) {
  ClosestPoint best = closest_on_point(vertices, 0);
  if (marked[0]) best = nearer(best, closest_on_triangle(vertices, 1, 2, 3));
  if (marked[1]) best = nearer(best, closest_on_triangle(vertices, 0, 2, 3));
  if (marked[2]) best = nearer(best, closest_on_triangle(vertices, 0, 1, 3));
  if (marked[3]) best = nearer(best, closest_on_triangle(vertices, 0, 1, 2));
  return best;
}

ClosestPoint closest_on_tetrahedron(const Vertices& vertices) {
  const Vec3 &p = vertices[0].w, &q = vertices[1].w;
  const Vec3 &r = vertices[2].w, &t = vertices[3].w;

  // Signed volumes opposite to the vertices, times 6, against that of the whole. Where
  // rounding of a vertex may turn that one inside out, the tetrahedron is flat, and
  // every face a candidate
  const Vec3 pq = q - p, pr = r - p, pt = t - p;
  const Real whole = glm::dot(pq, glm::cross(pr, pt));
  const Real a = glm::length(pq), b = glm::length(pr), c = glm::length(pt);
  if (!(std::abs(whole) > k_rounding * (a * b + b * c + c * a)))
    return closest_on_faces(vertices, {true, true, true, true});
  const Vec3 q_r = glm::cross(q, r), t_p = glm::cross(t, p);
  const std::array volumes{glm::dot(q_r, t) / whole, -glm::dot(t_p, r) / whole,
                           glm::dot(t_p, q) / whole, -glm::dot(q_r, p) / whole};
  const std::array outside{!(volumes[0] > 0), !(volumes[1] > 0), !(volumes[2] > 0),
                           !(volumes[3] > 0)};
  if (outside[0] || outside[1] || outside[2] || outside[3])
    return closest_on_faces(vertices, outside);
  return {Vec3(0), volumes};
}

}  // namespace

Vec3 area_normal(const Vec3& p, const Vec3& q, const Vec3& r) {
  constexpr Real k_thin = Real(1) / 64;  // sine of the angle at p
  const Vec3 e = q - p, f = r - p, n = glm::cross(e, f);
  if (squared(n) > k_thin * k_thin * squared(e) * squared(f)) return n;

  // From the two shorter edges, of which less cancels
  const WideVec3 pq = WideVec3(q) - WideVec3(p), qr = WideVec3(r) - WideVec3(q);
  const WideVec3 rp = WideVec3(p) - WideVec3(r);
  const Wide pq2 = glm::dot(pq, pq), qr2 = glm::dot(qr, qr), rp2 = glm::dot(rp, rp);
  if (qr2 >= pq2 && qr2 >= rp2) return Vec3(glm::cross(rp, pq));
  return Vec3(rp2 >= pq2 ? glm::cross(pq, qr) : glm::cross(qr, rp));
}

ClosestPoint closest_to_origin(const Simplex& simplex) {
  const Vertices& v = simplex.vertices;
  switch (simplex.size) {
    case 1:
      return closest_on_point(v, 0);
    case 2:
      return closest_on_segment(v, 0, 1);
    case 3:
      return closest_on_triangle(v, 0, 1, 2);
    default:
      return closest_on_tetrahedron(v);
  }
}

ClosestPoint closest_on_face(const Simplex& simplex) {
  if (simplex.size < 4) return closest_to_origin(simplex);
  return closest_on_faces(simplex.vertices, {true, true, true, true});
}

void keep(Simplex& simplex, const ClosestPoint& closest) {
  Index kept = 0;
  for (Index i = 0; i < Index(simplex.size); ++i) {
    if (!(closest.weights[i] > 0)) continue;
    if (kept < i) simplex.vertices[kept] = simplex.vertices[i];
    simplex.weights[kept++] = closest.weights[i];
  }
  simplex.size = int(kept);
}

Vec3 reduce_to_closest(Simplex& simplex) {
  const ClosestPoint closest = closest_to_origin(simplex);
  keep(simplex, closest);
  return closest.point;
}

Vec3 reduce_to_closest_face(Simplex& simplex) {
  const ClosestPoint closest = closest_on_face(simplex);
  keep(simplex, closest);
  return closest.point;
}

Vec3 witness_on_a(const Simplex& simplex) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < std::size_t(simplex.size); ++i)
    sum += simplex.weights[i] * simplex.vertices[i].a;
  return sum;
}

Vec3 witness_on_b(const Simplex& simplex) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < std::size_t(simplex.size); ++i)
    sum += simplex.weights[i] * simplex.vertices[i].b;
  return sum;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
