#include "common/physics/mass_properties.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace timestep::inline TIMESTEP_PRECISION {
namespace {

constexpr Real k_pi = std::numbers::pi_v<Real>;
constexpr Real k_u = std::numeric_limits<Real>::epsilon() / 2;

Mat3 diagonal(const Vec3& d) {
  return {d.x, 0, 0, 0, d.y, 0, 0, 0, d.z};
}

// Of even density, about the origin
MassProperties centred(Real mass, const Vec3& moments) {
  return {mass, Vec3(0), diagonal(moments)};
}

// (3.7) The tensor of a point of mass 1 at r
Mat3 point_inertia(const Vec3& r) {
  return diagonal(Vec3(glm::dot(r, r))) - glm::outerProduct(r, r);
}

Real largest_entry(const Mat3& m) {
  Real largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(m[i][j]));
  return largest;
}

// Turns the axes p and q in their plane so that I[p][q] becomes 0
void turn(Mat3& I, Mat3& A, int p, int q) {
  // The smaller of the two angles that do so, by its tangent t
  const Real cotangent_2 = (I[q][q] - I[p][p]) / (2 * I[p][q]);
  const Real size = std::abs(cotangent_2) + std::hypot(cotangent_2, Real(1));
  const Real t = std::copysign(1 / size, cotangent_2);
  const Real c = 1 / std::hypot(t, Real(1));
  const Real s = t * c;

  // A^T I A with the turned A, entry by entry
  const int r = 3 - p - q;
  const Real change = t * I[p][q];
  const Real rp = I[r][p], rq = I[r][q];
  I[p][p] -= change;
  I[q][q] += change;
  I[p][q] = I[q][p] = 0;
  I[r][p] = I[p][r] = c * rp - s * rq;
  I[r][q] = I[q][r] = s * rp + c * rq;

  const Vec3 a = A[p];
  A[p] = c * a - s * A[q];
  A[q] = s * a + c * A[q];
}

// Swaps two axes where their moments are in the wrong order
void sort(PrincipalAxes& axes, int i, int j) {
  if (axes.moments[i] <= axes.moments[j]) return;
  std::swap(axes.moments[i], axes.moments[j]);
  std::swap(axes.A[i], axes.A[j]);
}

}  // namespace

MassProperties solid_box(Real mass, const Vec3& size) {
  const Vec3 s2 = size * size;
  return centred(mass, mass / 12 * Vec3(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y));
}

MassProperties solid_sphere(Real mass, Real radius) {
  return centred(mass, Vec3(2 * mass * radius * radius / 5));
}

MassProperties spherical_shell(Real mass, Real radius) {
  return centred(mass, Vec3(2 * mass * radius * radius / 3));
}

MassProperties solid_ellipsoid(Real mass, const Vec3& semi_axes) {
  const Vec3 s2 = semi_axes * semi_axes;
  return centred(mass, mass / 5 * Vec3(s2.y + s2.z, s2.z + s2.x, s2.x + s2.y));
}

MassProperties solid_cylinder(Real mass, Real radius, Real height) {
  return hollow_cylinder(mass, 0, radius, height);
}

MassProperties hollow_cylinder(Real mass, Real inner, Real outer, Real height) {
  const Real r2 = inner * inner + outer * outer;
  const Real across = mass * (3 * r2 + height * height) / 12;
  return centred(mass, {across, across, mass * r2 / 2});
}

MassProperties solid_capsule(Real mass, Real radius, Real height) {
  // A cylinder, and a ball in two halves with their centres h / 2 + 3 r / 8 off
  const Real h = height, r = radius;
  const Real cylinder = h > 0 ? mass * (h / (h + 4 * r / 3)) : 0;
  const Real ball = mass - cylinder;
  const Real along = r * r * (cylinder / 2 + 2 * ball / 5);
  const Real across = cylinder * (3 * r * r + h * h) / 12
                      + ball * (2 * r * r / 5 + h * (h / 4 + 3 * r / 8));
  return centred(mass, {across, across, along});
}

MassProperties solid_cone(Real mass, Real radius, Real height) {
  const Real r2 = radius * radius;
  const Real across = 3 * mass * (4 * r2 + height * height) / 80;
  return {mass, {0, 0, height / 4}, diagonal({across, across, 3 * mass * r2 / 10})};
}

MassProperties solid_torus(Real mass, Real major, Real minor) {
  const Real R = major, r = minor;
  const Real across = mass * (4 * R * R + 5 * r * r) / 8;
  return centred(mass, {across, across, mass * (4 * R * R + 3 * r * r) / 4});
}

MassProperties thin_rod(Real mass, Real length) {
  return hollow_cylinder(mass, 0, 0, length);
}

MassProperties solid_tetrahedron(Real mass, const Vec3& a, const Vec3& b, const Vec3& c,
                                 const Vec3& d) {
  // As if a twentieth of the mass sat in each vertex and the rest in the centre
  const Vec3 centre = a + (b - a + (c - a) + (d - a)) / Real(4);
  Mat3 inertia(0);
  for (const Vec3& vertex : {a, b, c, d})
    inertia += mass / 20 * point_inertia(vertex - centre);
  return {mass, centre, inertia};
}

Real box_volume(const Vec3& size) {
  return size.x * size.y * size.z;
}

Real sphere_volume(Real radius) {
  return ellipsoid_volume(Vec3(radius));
}

Real ellipsoid_volume(const Vec3& semi_axes) {
  return 4 * k_pi / 3 * semi_axes.x * semi_axes.y * semi_axes.z;
}

Real cylinder_volume(Real radius, Real height) {
  return hollow_cylinder_volume(0, radius, height);
}

Real hollow_cylinder_volume(Real inner, Real outer, Real height) {
  return k_pi * (outer - inner) * (outer + inner) * height;
}

Real capsule_volume(Real radius, Real height) {
  return cylinder_volume(radius, height) + sphere_volume(radius);
}

Real cone_volume(Real radius, Real height) {
  return cylinder_volume(radius, height) / 3;
}

Real torus_volume(Real major, Real minor) {
  return 2 * k_pi * k_pi * major * minor * minor;
}

Real tetrahedron_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::abs(glm::dot(b - a, glm::cross(c - a, d - a))) / 6;
}

MassProperties moved(const MassProperties& body, const Quat& rotation,
                     const Vec3& translation) {
  const Mat3 R = matrix_of(rotation);
  return {body.mass, R * body.centre_of_mass + translation,
          R * body.inertia * glm::transpose(R)};
}

Mat3 inertia_about(const MassProperties& body, const Vec3& point) {
  return body.inertia + body.mass * point_inertia(body.centre_of_mass - point);
}

MassProperties combined(std::span<const MassProperties> parts) {
  // (3.6) The centre, from the first part's so that far away is as good as near
  const Vec3 near = parts.front().centre_of_mass;
  Real mass = 0;
  Vec3 moment(0);
  for (const MassProperties& part : parts) {
    mass += part.mass;
    moment += part.mass * (part.centre_of_mass - near);
  }
  MassProperties whole{mass, near + moment / mass, Mat3(0)};

  // (3.9) Tensors add up about a common point
  for (const MassProperties& part : parts)
    whole.inertia += inertia_about(part, whole.centre_of_mass);
  return whole;
}

PrincipalAxes principal_axes(const Mat3& inertia) {
  const Real scale = largest_entry(inertia);
  if (scale == 0) return {Vec3(0), Mat3(1)};
  Mat3 I = (inertia + glm::transpose(inertia)) / (2 * scale);
  Mat3 A(1);

  // What a turn leaves of the other entries shrinks with its square: 3 or 4 sweeps do
  for (int sweep = 0; sweep < 8; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}})
      if (std::abs(I[p][q]) > k_u / 4) turn(I, A, p, q);

  PrincipalAxes axes{scale * Vec3(I[0][0], I[1][1], I[2][2]), A};
  sort(axes, 0, 1);
  sort(axes, 1, 2);
  sort(axes, 0, 1);
  if (glm::determinant(axes.A) < 0) axes.A[2] = -axes.A[2];
  return axes;
}

bool is_inertia(const Mat3& inertia) {
  const Real rounding = 16 * k_u * largest_entry(inertia);
  const Mat3 skew = inertia - glm::transpose(inertia);
  const Vec3 I = principal_axes(inertia).moments;

  // One entry that is not finite makes the sum of all so
  return std::isfinite(glm::dot(Vec3(1), inertia * Vec3(1)))
         && largest_entry(skew) <= rounding && I.x >= -rounding
         && I.x + I.y >= I.z - rounding;
}

}  // namespace timestep::inline TIMESTEP_PRECISION
