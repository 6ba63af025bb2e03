// Solids whose properties are rational numbers: a tetrahedron with one corner in the
// origin, boxes near and far, and a square ring, where the middle is not in the body.
#include "chapters/03-rigid-bodies/exercises/3_4_mesh.hpp"

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "tests/exercise.hpp"

using namespace timestep;

namespace {

constexpr double k_u = std::numeric_limits<double>::epsilon() / 2;

struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  // Corners counter-clockwise as seen from outside
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
  }
};

// Four corners of a rectangle around `centre`, counter-clockwise from above
void add_corners(Mesh& mesh, const Vec3& centre, Real x, Real y, Real z) {
  for (const auto& [sx, sy] :
       {std::array{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
    mesh.vertices.push_back(centre + Vec3(sx * x, sy * y, z));
}

Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

// 1 m x 2 m x 3 m
Mesh box(const Vec3& centre) {
  Mesh mesh;
  add_corners(mesh, centre, 1, 2, -1.5);
  add_corners(mesh, centre, 1, 2, 1.5);
  mesh.add_quad(3, 2, 1, 0);
  mesh.add_quad(4, 5, 6, 7);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    mesh.add_quad(i, j, j + 4, i + 4);
  }
  return mesh;
}

// 4 m x 4 m x 1 m without 2 m x 2 m x 1 m: outside and inside below, then above
Mesh ring(const Vec3& centre) {
  Mesh mesh;
  for (const Real z : {-0.5, 0.5})
    for (const Real side : {4.0, 2.0}) add_corners(mesh, centre, side, side, z);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    mesh.add_quad(i, j, j + 8, i + 8);
    mesh.add_quad(j + 4, i + 4, i + 12, j + 12);
    mesh.add_quad(i + 8, j + 8, j + 12, i + 12);
    mesh.add_quad(j, i, i + 4, j + 4);
  }
  return mesh;
}

// Sums over up to 32 tetrahedra, each rounded a few times to u of what it can be at
// places not further than `reach` from its fourth corner
void expect_solid(const std::string& what, Real density, const Mesh& mesh,
                  const MassProperties& right, Real reach) {
  const MassProperties yours = solid(density, mesh.vertices, mesh.triangles);
  const Real roundings = 4 * Real(mesh.triangles.size()) * k_u;
  expect("mass [kg] of " + what, yours.mass, right.mass, roundings * right.mass);
  expect("centre of mass [m] of " + what, yours.centre_of_mass, right.centre_of_mass,
         roundings * reach + 2 * k_u * glm::length(right.centre_of_mass));
  for (const int i : {0, 1, 2})
    expect(fmt::format("column {} [kg m²] of the inertia tensor of {}", i + 1, what),
           yours.inertia[i], right.inertia[i], roundings * right.mass * reach * reach);
}

Mat3 diagonal(Real x, Real y, Real z) {
  return {x, 0, 0, 0, y, 0, 0, 0, z};
}

}  // namespace

TEST_CASE("a tetrahedron's volume has a sign") {
  expect("volume [m³] over (1, 0, 0), (0, 2, 0), (0, 0, 3)",
         signed_volume({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), 1, 0);
  expect("volume [m³] over (1, 0, 0), (0, 0, 3), (0, 2, 0)",
         signed_volume({1, 0, 0}, {0, 0, 3}, {0, 2, 0}), -1, 0);
}

TEST_CASE("a box about the origin") {
  const std::string what = "a box of 1 m x 2 m x 3 m and 6 kg";
  expect_solid(what, 1, box(Vec3(0)), {6, Vec3(0), diagonal(6.5, 5, 2.5)}, 4);
}

TEST_CASE("a tetrahedron, whose axes are not its principal axes") {
  const Mat3 I{0.4875, 0.025, 0.0375, 0.025, 0.375, 0.075, 0.0375, 0.075, 0.1875};
  expect_solid("the tetrahedron (0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3) of 1 kg", 1,
               tetrahedron(), {1, {0.25, 0.5, 0.75}, I}, 3);
  expect_solid("the same tetrahedron of 8 kg", 8, tetrahedron(),
               {8, {0.25, 0.5, 0.75}, Real(8) * I}, 3);
}

TEST_CASE("a ring, whose centre of mass is in the air") {
  expect_solid("a ring of 4 m x 4 m x 1 m without 2 m x 2 m x 1 m", 1, ring(Vec3(0)),
               {12, Vec3(0), diagonal(21, 21, 40)}, 6);
}

TEST_CASE("it does not matter how far from the origin a body is") {
  const Vec3 far{1e6, 1e6, -1e6};
  expect_solid("the box a thousand kilometres away", 1, box(far),
               {6, far, diagonal(6.5, 5, 2.5)}, 4);
  expect_solid("the ring a thousand kilometres away", 1, ring(far),
               {12, far, diagonal(21, 21, 40)}, 6);
}
