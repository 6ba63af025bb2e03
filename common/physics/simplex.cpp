#include "common/physics/simplex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

// From the two shorter edges, of which less cancels
Vec3 wide_area_normal(const Vec3& p, const Vec3& q, const Vec3& r) {
  const WideVec3 pq = WideVec3(q) - WideVec3(p), qr = WideVec3(r) - WideVec3(q);
  const WideVec3 rp = WideVec3(p) - WideVec3(r);
  const Wide pq2 = glm::dot(pq, pq), qr2 = glm::dot(qr, qr), rp2 = glm::dot(rp, rp);
  if (qr2 >= pq2 && qr2 >= rp2) return Vec3(glm::cross(rp, pq));
  return Vec3(rp2 >= pq2 ? glm::cross(pq, qr) : glm::cross(qr, rp));
}

using Index = std::size_t;
using Vertices = std::array<SupportPoint, 4>;

// The closest point of all parts of a simplex that were tried, and how far it is
struct Search {
  const Vertices& vertices;
  ClosestPoint& best;
  Real least = std::numeric_limits<Real>::infinity();  // squared
};

// Whether a point is closer than those before; then its weights are for the caller
bool takes(Search& search, const Vec3& point) {
  const Real distance = squared(point);
  if (!(distance < search.least)) return false;
  search.least = distance;
  search.best.point = point;
  search.best.weights = {};
  return true;
}

void try_point(Search& search, Index i) {
  if (takes(search, search.vertices[i].w)) search.best.weights[i] = 1;
}

void try_segment(Search& search, Index i, Index j) {
  const Vec3 &p = search.vertices[i].w, &q = search.vertices[j].w;
  const Vec3 e = q - p;

  // Lengths from the foot of the perpendicular to either end, times |e|
  const Real from_p = -glm::dot(p, e), to_q = glm::dot(q, e);
  if (!(from_p > 0)) return try_point(search, i);
  if (!(to_q > 0)) return try_point(search, j);
  const Real t = from_p / (from_p + to_q);

  // From the nearer end
  const Vec3 foot = t < Real(0.5) ? p + t * e : q - (1 - t) * e;
  if (!takes(search, without(foot, e))) return;
  search.best.weights[i] = 1 - t;
  search.best.weights[j] = t;
}

// From the vertex nearest to the origin
Vec3 foot_on_plane(const Vec3& n, const Vec3& p, const Vec3& q, const Vec3& r) {
  Vec3 nearest = squared(q) < squared(p) ? q : p;
  if (squared(r) < squared(nearest)) nearest = r;
  return n * (glm::dot(n, nearest) / squared(n));
}

void try_triangle(Search& search, Index i, Index j, Index k) {
  const Vec3 &p = search.vertices[i].w, &q = search.vertices[j].w;
  const Vec3& r = search.vertices[k].w;
  const Vec3 n = area_normal(p, q, r);
  const Vec3 foot = foot_on_plane(n, p, q, r);

  // Signed areas opposite to the vertices, times |n|
  const Vec3 fp = p - foot, fq = q - foot, fr = r - foot;
  const Real area_p = glm::dot(n, glm::cross(fq, fr));
  const Real area_q = glm::dot(n, glm::cross(fr, fp));
  const Real area_r = glm::dot(n, glm::cross(fp, fq));
  if (!(area_p > 0) || !(area_q > 0) || !(area_r > 0)) {
    try_point(search, i);
    if (!(area_p > 0)) try_segment(search, j, k);
    if (!(area_q > 0)) try_segment(search, k, i);
    if (!(area_r > 0)) try_segment(search, i, j);
    return;
  }
  const Real whole = area_p + area_q + area_r;
  Real weight_p = area_p / whole, weight_q = area_q / whole, weight_r = area_r / whole;

  // The foot keeps its direction where it is next to the origin, but loses its length
  // where the triangle is a sliver; the weighted sum is in the triangle whatever
  // happens. What is wrong with that one is along the triangle: on to where it is
  // closest to the origin
  Vec3 point = foot;
  const Vec3 sum = weight_p * p + weight_q * q + weight_r * r;
  if (squared(sum - foot) > k_rounding * k_rounding / 64) {
    const bool is_to_q = squared(q - p) > squared(r - p);
    Real& weight_end = is_to_q ? weight_q : weight_r;
    const Vec3 e = (is_to_q ? q : r) - p;
    const Real step = std::clamp(-glm::dot(sum, e) / squared(e), -weight_end, weight_p);
    weight_p -= step;
    weight_end += step;
    point = sum + step * e;
  }
  if (!takes(search, point)) return;
  search.best.weights[i] = weight_p;
  search.best.weights[j] = weight_q;
  search.best.weights[k] = weight_r;
}

// The faces opposite to the vertices that are marked
void try_faces(Search& search, const std::array<bool, 4>& marked) {
  try_point(search, 0);
  if (marked[0]) try_triangle(search, 1, 2, 3);
  if (marked[1]) try_triangle(search, 0, 2, 3);
  if (marked[2]) try_triangle(search, 0, 1, 3);
  if (marked[3]) try_triangle(search, 0, 1, 2);
}

void try_tetrahedron(Search& search) {
  const Vec3 &p = search.vertices[0].w, &q = search.vertices[1].w;
  const Vec3 &r = search.vertices[2].w, &t = search.vertices[3].w;

  // Signed volumes opposite to the vertices, times 6, against that of the whole. Where
  // rounding of a vertex may turn that one inside out, the tetrahedron is flat, and
  // every face a candidate
  const Vec3 pq = q - p, pr = r - p, pt = t - p;
  const Real whole = glm::dot(pq, glm::cross(pr, pt));
  const Real a = glm::length(pq), b = glm::length(pr), c = glm::length(pt);
  if (!(std::abs(whole) > k_rounding * (a * b + b * c + c * a)))
    return try_faces(search, {true, true, true, true});
  const Vec3 q_r = glm::cross(q, r), t_p = glm::cross(t, p);
  const std::array volumes{glm::dot(q_r, t) / whole, -glm::dot(t_p, r) / whole,
                           glm::dot(t_p, q) / whole, -glm::dot(q_r, p) / whole};
  const std::array outside{!(volumes[0] > 0), !(volumes[1] > 0), !(volumes[2] > 0),
                           !(volumes[3] > 0)};
  if (outside[0] || outside[1] || outside[2] || outside[3])
    return try_faces(search, outside);
  search.best.point = Vec3(0);
  search.best.weights = volumes;
}

// The first vertex, if numbers that are not finite leave no other
ClosestPoint first_vertex(const Simplex& simplex) {
  return {simplex.vertices[0].w, {1, 0, 0, 0}};
}

}  // namespace

Vec3 area_normal(const Vec3& p, const Vec3& q, const Vec3& r) {
  constexpr Real k_thin = Real(1) / 64;  // sine of the angle at p
  const Vec3 e = q - p, f = r - p;
  Vec3 n = glm::cross(e, f);
  if (!(squared(n) > k_thin * k_thin * squared(e) * squared(f)))
    n = wide_area_normal(p, q, r);
  return n;
}

ClosestPoint closest_to_origin(const Simplex& simplex) {
  ClosestPoint closest = first_vertex(simplex);
  Search search{simplex.vertices, closest};
  if (simplex.size == 2) try_segment(search, 0, 1);
  if (simplex.size == 3) try_triangle(search, 0, 1, 2);
  if (simplex.size == 4) try_tetrahedron(search);
  return closest;
}

ClosestPoint closest_on_face(const Simplex& simplex) {
  if (simplex.size < 4) return closest_to_origin(simplex);
  ClosestPoint closest = first_vertex(simplex);
  Search search{simplex.vertices, closest};
  try_faces(search, {true, true, true, true});
  return closest;
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
