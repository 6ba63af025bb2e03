// Chapter 3's mass properties: primitive shapes, parts, principal axes, and meshes
// against them. Compiled for each precision; u (k_u) is the unit round-off of the one
// at hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "common/physics/mesh_mass.hpp"
#include "tests/catch.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr Real k_nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real k_infinity = std::numeric_limits<Real>::infinity();

double largest(const Mat3& m) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(double(m[i][j])));
  return most;
}

// Of the largest entry, in units of u
double apart(const Mat3& a, const Mat3& b) {
  const double size = largest(b);
  return size > 0 ? largest(a - b) / (k_u * size) : largest(a);
}

Mat3 diagonal(const Vec3& d) {
  return {d.x, 0, 0, 0, d.y, 0, 0, 0, d.z};
}

// Turns of all kinds: none, about an axis, of a quarter, tiny, and any
std::vector<Quat> some_turns() {
  const auto q = [](double w, double x, double y, double z) {
    return Quat(glm::normalize(glm::dquat(w, x, y, z)));
  };
  return {q(1, 0, 0, 0),     q(1, 1, 0, 0),           q(1, 0, 1e-4, 0),
          q(1, 1, 1, 1),     q(3, 1, -4, 1.5),        q(0.2, -3, 1, 2),
          q(0, 0, 1, 1),     q(1, 1e-6, 2e-6, -1e-6), q(5, 9, -2, -6),
          q(-1, 0.3, 7, 0.1)};
}

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

// From -size / 2 to size / 2 about `at`
Mesh box_mesh(const Vec3& size, const Vec3& at = Vec3(0)) {
  Mesh mesh;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1})
        mesh.vertices.push_back(at + size / Real(2) * Vec3(x, y, z));
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

void join(Mesh& onto, const Mesh& from) {
  const auto shift = std::uint32_t(onto.vertices.size());
  onto.vertices.insert(onto.vertices.end(), from.vertices.begin(), from.vertices.end());
  for (const auto& [i, j, k] : from.triangles)
    onto.triangles.push_back({i + shift, j + shift, k + shift});
}

// 4 m x 4 m x 1 m with a hole of 2 m x 2 m, about `at`
Mesh ring_mesh(const Vec3& at) {
  Mesh mesh;
  for (const double z : {-0.5, 0.5})
    for (const double half : {2.0, 1.0})
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        mesh.vertices.push_back(at + Vec3(half * x, half * y, z));
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                          std::uint32_t d) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    };
    quad(i, j, 8 + j, 8 + i);
    quad(4 + j, 4 + i, 12 + i, 12 + j);
    quad(8 + i, 8 + j, 12 + j, 12 + i);
    quad(j, i, 4 + i, 4 + j);
  }
  return mesh;
}

MassProperties mass_of(const Mesh& mesh, Real density = 1) {
  return mesh_mass(density, mesh.vertices, mesh.triangles);
}

std::string fault_of(const Mesh& mesh) {
  return mesh_fault(mesh.vertices, mesh.triangles);
}

}  // namespace

TEST_CASE("shapes that are the same are the same") {
  // A formula rounds at most 10 times
  const auto same = [](const MassProperties& a, const MassProperties& b) {
    return a.mass == b.mass && a.centre_of_mass == b.centre_of_mass
           && apart(a.inertia, b.inertia) <= 10;
  };
  const Real m = Real(2.7), r = Real(0.3), h = Real(1.9);
  CHECK(same(solid_ellipsoid(m, Vec3(r)), solid_sphere(m, r)));
  CHECK(same(solid_capsule(m, r, 0), solid_sphere(m, r)));
  CHECK(same(solid_capsule(m, 0, h), thin_rod(m, h)));
  CHECK(same(solid_box(m, {0, 0, h}), thin_rod(m, h)));
  CHECK(same(hollow_cylinder(m, 0, r, h), solid_cylinder(m, r, h)));
  CHECK(same(solid_torus(m, r, 0), hollow_cylinder(m, r, r, 0)));
  CHECK(solid_capsule(m, 0, 0).inertia == Mat3(0));
  CHECK(capsule_volume(r, 0) == sphere_volume(r));
}

TEST_CASE("a part of negative mass is a hole") {
  const Real density = 3, a = Real(0.4), b = Real(0.5), h = 2;
  const std::array parts{solid_cylinder(density * cylinder_volume(b, h), b, h),
                         solid_cylinder(-density * cylinder_volume(a, h), a, h)};
  const MassProperties tube = combined(parts);
  const Real mass = density * hollow_cylinder_volume(a, b, h);

  // The parts are up to (1 - 0.8^2)^-1 = 2.8 times the tube, and round 8 times each
  CHECK(tube.mass == Approx(mass).epsilon(3 * 16 * k_u));
  CHECK(apart(tube.inertia, hollow_cylinder(mass, a, b, h).inertia) < 3 * 16);
}

TEST_CASE("a hollow of a ball leaves a shell") {
  // A shell of thickness d differs from a thin one by d / r, to first order
  const double r = 1, d = 1.0 / 1024;
  const Real inner = Real(r - d);
  const std::array parts{solid_sphere(sphere_volume(1), 1),
                         solid_sphere(-sphere_volume(inner), inner)};
  const MassProperties ball = combined(parts);
  const Mat3 thin = spherical_shell(ball.mass, 1).inertia;
  CHECK(largest(ball.inertia - thin) / largest(thin) < d + 16 * k_u / (3 * d));
}

TEST_CASE("six tetrahedra make a box") {
  const Vec3 size(Real(1.5), Real(0.4), Real(2.2)), at(3, -2, 5);
  const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  const Vec3 o = at - size / Real(2);
  std::vector<MassProperties> parts;
  Real volume = 0;
  for (const auto& [p, q] : {std::pair{x, y}, {y, x}, {y, z}, {z, y}, {z, x}, {x, z}}) {
    const std::array corners{o, o + p, o + p + q, o + size};
    volume += tetrahedron_volume(corners[0], corners[1], corners[2], corners[3]);
    parts.push_back(
        solid_tetrahedron(1, corners[0], corners[1], corners[2], corners[3]));
  }
  const MassProperties box = combined(parts);

  // Corners are rounded by u |at|, three times the box's size; each of six parts then
  // rounds 8 times
  CHECK(volume == Approx(box_volume(size)).epsilon(3 * 6 * 8 * k_u));
  CHECK(glm::distance(box.centre_of_mass, at) < 8 * k_u * glm::length(at));
  CHECK(apart(box.inertia, solid_box(6, size).inertia) < 3 * 6 * 8);
}

TEST_CASE("the parallel axis: a rod about its end, and there and back") {
  const Real m = 3, l = 2;
  const MassProperties rod = thin_rod(m, l);
  const Mat3 about_end = inertia_about(rod, {0, 0, l / 2});
  CHECK(apart(about_end, diagonal({4, 4, 0})) < 4);
  CHECK(inertia_about(rod, Vec3(0)) == rod.inertia);
}

TEST_CASE("a dumbbell is the same wherever it is") {
  // Places a float can hold, so that nothing but the answer is rounded
  for (const Real far : {Real(0), Real(1 << 20)}) {
    const Vec3 at(far, -far, far);
    MassProperties left = solid_sphere(2, Real(0.5)), right = left;
    left.centre_of_mass = at - Vec3(1, 0, 0);
    right.centre_of_mass = at + Vec3(1, 0, 0);
    const MassProperties both = combined(std::array{left, right});
    CHECK(both.mass == 4);
    CHECK(both.centre_of_mass == at);
    CHECK(apart(both.inertia, diagonal({Real(0.4), Real(4.4), Real(4.4)})) < 8);
  }
}

TEST_CASE("moving a body turns its tensor and shifts its centre") {
  const MassProperties box = solid_box(2, {1, 2, 3});
  for (const Quat& q : some_turns()) {
    const Vec3 shift(1, -2, Real(0.5));
    const MassProperties there = moved(box, q, shift);
    CHECK(there.mass == 2);
    CHECK(glm::distance(there.centre_of_mass, shift) == 0);

    // A quaternion's length and its matrix are right to 8 u, and count twice
    const MassProperties back =
        moved(there, glm::conjugate(q), -(glm::conjugate(q) * shift));
    CHECK(apart(back.inertia, box.inertia) < 2 * 2 * 16);
    CHECK(glm::length(back.centre_of_mass) < 32 * k_u * glm::length(shift));
  }
}

TEST_CASE("principal axes are found at any shape, size and attitude") {
  constexpr std::array<std::array<double, 3>, 10> moments{{{1, 2, 2.5},
                                                           {1, 1, 1},
                                                           {1, 1, 2},
                                                           {1, 2, 2},
                                                           {0, 1, 1},
                                                           {1e-6, 1, 1},
                                                           {1e-6, 1, 1 + 1e-6},
                                                           {1, 1 + 1e-7, 1 + 2e-7},
                                                           {1, 1e3, 1.0001e3},
                                                           {21, 21, 40}}};
  for (const auto& I : moments) {
    for (const Quat& q : some_turns()) {
      for (const double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
        INFO(I[0] << " " << I[1] << " " << I[2] << " times " << scale << ", turned by "
                  << q.w << " " << q.x << " " << q.y << " " << q.z);
        const glm::dmat3 R = glm::mat3_cast(glm::normalize(glm::dquat(q)));
        const glm::dmat3 D(scale * I[0], 0, 0, 0, scale * I[1], 0, 0, 0, scale * I[2]);
        const Mat3 tensor(R * D * glm::transpose(R));
        const auto [found, A] = principal_axes(tensor);

        // Rounding the tensor's entries moves a moment by 3 u of the largest; each of
        // at most 9 turns rounds 3 times more, at random
        const double bound = (3 + 9 * 3) * k_u * scale * I[2];
        for (int i = 0; i < 3; ++i)
          CHECK(std::abs(found[i] - scale * I[std::size_t(i)]) <= bound);
        CHECK(found.x <= found.y);
        CHECK(found.y <= found.z);
        CHECK(apart(A * diagonal(found) * glm::transpose(A), tensor) < 3 + 9 * 3 + 6);
        CHECK(apart(glm::transpose(A) * A, Mat3(1)) < 9 * 3);
        CHECK(glm::determinant(A) > 0);
        CHECK(is_inertia(tensor));
      }
    }
  }
}

TEST_CASE("axes that are principal already stay, and are only put in order") {
  CHECK(principal_axes(diagonal({1, 2, 2})).A == Mat3(1));
  const auto [moments, A] = principal_axes(diagonal({3, 1, 2}));
  CHECK(moments == Vec3(1, 2, 3));
  CHECK(A == Mat3(0, 1, 0, 0, 0, 1, 1, 0, 0));
  CHECK(principal_axes(Mat3(0)).moments == Vec3(0));

  // Noise far below rounding turns nothing
  Mat3 noisy = diagonal({21, 21, 40});
  noisy[0][1] = noisy[1][0] = Real(k_u);
  CHECK(principal_axes(noisy).A == Mat3(1));
}

TEST_CASE("tensors that no body has are told from those that one has") {
  CHECK(is_inertia(Mat3(0)));
  CHECK(is_inertia(diagonal({0, 1, 1})));
  CHECK(is_inertia(diagonal({1, 1, 2})));
  CHECK(is_inertia(thin_rod(2, 3).inertia));
  CHECK_FALSE(is_inertia(diagonal({1, 1, Real(2.001)})));
  CHECK_FALSE(is_inertia(diagonal({-1, 1, 1})));
  CHECK_FALSE(is_inertia(diagonal({0, 0, 1})));
  Mat3 skew = diagonal({1, 1, 1});
  skew[0][1] = Real(0.1);
  CHECK_FALSE(is_inertia(skew));
  for (const Real bad : {k_nan, k_infinity}) {
    Mat3 broken = diagonal({1, 1, 1});
    broken[1][2] = broken[2][1] = bad;
    CHECK_FALSE(is_inertia(broken));
    CHECK_FALSE(is_inertia(diagonal({1, bad, 1})));
  }
}

TEST_CASE("a mesh of a box weighs what a box weighs, near and far, large and small") {
  for (const Real size : {Real(1e-6), Real(1), Real(1e6)}) {
    for (const Real far : {Real(0), Real(1024)}) {
      const Vec3 sides = size * Vec3(1, Real(0.25), 2),
                 at = far * size * Vec3(1, -1, 1);
      const Mesh mesh = box_mesh(sides, at);
      REQUIRE(fault_of(mesh).empty());
      const MassProperties body = mass_of(mesh, 500);

      // Corners are rounded by u |at|, 1024 / 0.25 times the shortest side; six sides
      // of which two are off, and squares
      const double off = 8 + 4 * double(far) / 0.25;
      const Real mass = 500 * box_volume(sides);
      CHECK(body.mass == Approx(mass).epsilon(off * k_u));
      CHECK(glm::distance(body.centre_of_mass, at)
            <= 2 * k_u * (glm::length(at) + glm::length(sides)));
      CHECK(apart(body.inertia, solid_box(mass, sides).inertia) < 3 * off);
      const Real area = surface_area(mesh.vertices, mesh.triangles);
      CHECK(area == Approx(5.5 * size * size).epsilon(off * k_u));
    }
  }
}

TEST_CASE("a ring a million metres away keeps its tensor") {
  // A float holds these corners. The sums are exact but for a last rounding
  for (const Real far : {Real(0), Real(1e3), Real(1e6)}) {
    const Vec3 at = far * Vec3(1, 1, -1);
    const Mesh ring = ring_mesh(at);
    REQUIRE(fault_of(ring).empty());
    const MassProperties body = mass_of(ring);
    CHECK(body.mass == Approx(12).epsilon(2 * k_u));
    CHECK(glm::distance(body.centre_of_mass, at) <= 2 * k_u);
    CHECK(apart(body.inertia, diagonal({21, 21, 40})) <= 2);
    CHECK(mesh_volume(ring.vertices, flipped(ring.triangles))
          == -mesh_volume(ring.vertices, ring.triangles));
  }
}

TEST_CASE("a mesh of a tetrahedron is a tetrahedron") {
  const std::array<Vec3, 4> v{Vec3(0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)};
  const Mesh mesh{{v.begin(), v.end()}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MassProperties body = mass_of(mesh);
  const MassProperties solid = solid_tetrahedron(1, v[0], v[1], v[2], v[3]);
  CHECK(body.mass == Approx(1).epsilon(2 * k_u));
  CHECK(glm::distance(body.centre_of_mass, {Real(0.25), Real(0.5), Real(0.75)})
        < 4 * k_u);
  CHECK(apart(body.inertia, solid.inertia) < 16);
  CHECK(surface_area(mesh.vertices, mesh.triangles) == Approx(9).epsilon(4 * k_u));
}

TEST_CASE("vertices that no triangle uses do not count") {
  Mesh ring = ring_mesh(Vec3(0));
  ring.vertices.emplace_back(Real(1e18));
  CHECK(fault_of(ring).empty());
  CHECK(apart(mass_of(ring).inertia, diagonal({21, 21, 40})) <= 2);
}

TEST_CASE("seams, several parts and cavities are no faults") {
  // Each triangle with vertices of its own
  const Mesh box = box_mesh({1, 2, 3});
  Mesh loose;
  for (const Triangle& triangle : box.triangles) {
    const auto n = std::uint32_t(loose.vertices.size());
    for (const std::uint32_t i : triangle) loose.vertices.push_back(box.vertices[i]);
    loose.triangles.push_back({n, n + 1, n + 2});
  }
  CHECK(fault_of(loose).empty());

  Mesh two = box;
  join(two, box_mesh({1, 2, 3}, {5, 0, 0}));
  CHECK(fault_of(two).empty());
  CHECK(mesh_volume(two.vertices, two.triangles) == Approx(12).epsilon(2 * k_u));

  Mesh hollow = box_mesh({2, 2, 2});
  Mesh cavity = box_mesh({1, 1, 1});
  cavity.triangles = flipped(cavity.triangles);
  join(hollow, cavity);
  CHECK(fault_of(hollow).empty());
  CHECK(mesh_volume(hollow.vertices, hollow.triangles) == Approx(7).epsilon(2 * k_u));
}

TEST_CASE("minus zero is at the same place as zero") {
  Mesh mesh = box_mesh({1, 1, 1}, Vec3(Real(0.5)));
  const auto n = std::uint32_t(mesh.vertices.size());
  mesh.vertices.push_back(-mesh.vertices[0]);
  CHECK(std::signbit(mesh.vertices.back().x));
  std::ranges::replace(mesh.triangles[0], 0U, n);
  CHECK(fault_of(mesh).empty());
}

TEST_CASE("what keeps a mesh from being a solid is named and counted") {
  const Mesh box = box_mesh({1, 2, 3});
  CHECK(fault_of(box).empty());
  CHECK(fault_of({box.vertices, {}}) == "no triangles");

  Mesh bad = box;
  bad.vertices[5].y = k_nan;
  CHECK(fault_of(bad) == "vertex 5 is not finite");
  bad.vertices[5].y = -k_infinity;
  CHECK(fault_of(bad) == "vertex 5 is not finite");

  bad = box;
  bad.triangles[3][1] = 4'000'000'000;
  CHECK(fault_of(bad) == "index 4000000000 is out of range, there are 8 vertices");

  bad = box;
  bad.triangles.push_back({2, 2, 7});
  CHECK(fault_of(bad) == "1 triangle without area");
  bad.vertices.push_back((bad.vertices[0] + bad.vertices[1]) / Real(2));
  bad.triangles.push_back({0, 8, 1});
  CHECK(fault_of(bad) == "2 triangles without area");

  bad = box;
  bad.triangles.pop_back();
  CHECK(fault_of(bad) == "not closed: 3 boundary edges");

  bad = box;
  bad.triangles.push_back(bad.triangles[4]);
  CHECK(fault_of(bad) == "3 edges with more than two triangles");

  bad = box;
  std::swap(bad.triangles[0][0], bad.triangles[0][1]);
  CHECK(fault_of(bad) == "3 edges between opposite windings");

  // The same sheet from both sides
  CHECK(fault_of({box.vertices, {{0, 1, 3}, {0, 3, 1}}}) == "no volume");

  bad = box;
  bad.triangles = flipped(bad.triangles);
  CHECK(fault_of(bad) == "inside out: volume -6 m³");
  for (Vec3& vertex : bad.vertices) vertex *= Real(1e-3);
  CHECK(fault_of(bad) == "inside out: volume -6e-09 m³");
}

TEST_CASE("thin is not flat") {
  // A plate a hundred thousand times wider than thick, standing on its corner
  const Real thin = 1 / Real(1 << 17);
  Mesh plate = box_mesh({1, 1, thin});
  for (Vec3& v : plate.vertices) v = Vec3(v.x + v.z, v.y - v.z, v.z - v.x + v.y);
  CHECK(fault_of(plate).empty());

  // The shear has the determinant 3, and every sum is exact in a float
  CHECK(mesh_volume(plate.vertices, plate.triangles)
        == Approx(3 * double(thin)).epsilon(4 * k_u));
}
