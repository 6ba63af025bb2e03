// Chapter 4's decomposition of concave meshes. Compiled for each precision.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/physics/decomposition.hpp"
#include "tests/catch.hpp"
#include "tests/obj_mesh.hpp"
#include "tests/polyhedra.hpp"

using namespace timestep;

namespace {

using Mesh = ObjMesh;

Mesh read_mesh(const std::string& name) {
  return read_obj(TIMESTEP_MESHES "/" + name);
}

// An L of four cubes, turned by an angle about z
Mesh corner_piece(Real angle) {
  Mesh mesh;
  const std::vector<Vec3> outline{{0, 0, 0}, {3, 0, 0}, {3, 1, 0},
                                  {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (const Real z : {Real(0), Real(1)})
    for (const Vec3& p : outline)
      mesh.vertices.push_back(rotation_by({0, 0, angle}) * (p + Vec3(0, 0, z)));
  const std::vector<Triangle> top{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (const auto& [i, j, k] : top) {
    mesh.triangles.push_back({i, k, j});
    mesh.triangles.push_back({i + 6, j + 6, k + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

// How far the furthest vertex of the mesh is from all parts, as their planes tell
double uncovered(const Mesh& mesh, const std::vector<ConvexHull>& parts) {
  double most = 0;
  for (const Vec3& v : mesh.vertices) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const ConvexHull& part : parts) {
      double highest = -std::numeric_limits<double>::infinity();
      for (const Plane& plane : part.planes)
        highest = std::max(highest, double(glm::dot(plane.normal, v) - plane.offset));
      nearest = std::min(nearest, highest);
    }
    most = std::max(most, nearest);
  }
  return most;
}

}  // namespace

TEST_CASE("an L of four cubes is two boxes") {
  const Mesh mesh = corner_piece(0);
  REQUIRE(mesh_fault(mesh.vertices, mesh.triangles).empty());
  const Decomposition d = decompose(mesh.vertices, mesh.triangles);
  CHECK(d.mesh_volume == Approx(4));
  CHECK(d.hull_volume == Approx(5));
  CHECK(d.parts_volume == Approx(4));
  REQUIRE(d.parts.size() == 2);
  for (const ConvexHull& part : d.parts) CHECK(part.planes.size() == 6);

  // Beside the axes it takes more cuts, and what they add gets less and less
  const Mesh turned = corner_piece(Real(0.5));
  Real last = 5;
  for (const int parts : {2, 4, 8, 16}) {
    const Decomposition t =
        decompose(turned.vertices, turned.triangles, {.parts = parts, .least_gain = 0});
    CHECK(t.parts.size() <= std::size_t(parts));
    CHECK(t.parts_volume < last);
    CHECK(t.parts_volume >= t.mesh_volume * Real(1 - 64 * k_u));
    CHECK(uncovered(turned, t.parts) < 64 * k_u);
    last = t.parts_volume;
  }
  CHECK(last < 4.1);
}

TEST_CASE("the parts of real meshes cover them, with less volume than the hull") {
  struct Expected {
    const char* file;
    double most_over;  // parts over mesh, in volumes of the mesh
  };
  for (const auto& [file, most_over] :
       {Expected{"bunny.obj", 0.06}, Expected{"wrench.obj", 0.15},
        Expected{"knot.obj", 0.3}}) {
    const Mesh mesh = read_mesh(file);
    INFO(file << ": " << mesh.vertices.size() << " vertices");
    const Decomposition d =
        decompose(mesh.vertices, mesh.triangles, {.least_gain = Real(0.001)});
    REQUIRE(d.fault.empty());
    CHECK(d.parts.size() <= 16);
    CHECK(d.mesh_volume <= d.parts_volume);
    CHECK(d.parts_volume < d.hull_volume);
    CHECK(d.parts_volume / d.mesh_volume - 1 < most_over);
    CHECK(uncovered(mesh, d.parts) < 64 * k_u);
  }
}

TEST_CASE("what is convex stays whole, and what is no solid is refused") {
  const ConvexHull box = box_hull({1, 2, 3});
  CHECK(decompose(box.vertices, hull_triangles(box)).parts.size() == 1);
  Mesh open = corner_piece(0);
  open.triangles.pop_back();
  const Decomposition refused = decompose(open.vertices, open.triangles);
  CHECK(refused.parts.empty());
  CHECK(refused.fault.starts_with("not closed"));
}
