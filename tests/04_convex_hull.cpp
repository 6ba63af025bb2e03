// Chapter 4's convex hulls: against libqhull where it is installed, against what every
// polyhedron keeps, and on clouds that are hard. Compiled for each precision; u (k_u)
// is the unit round-off of the one at hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "common/physics/convex_hull.hpp"
#include "common/physics/side_of_plane.hpp"
#include "tests/catch.hpp"
#include "tests/polyhedra.hpp"

#ifdef TIMESTEP_HAS_QHULL
extern "C" {
#include <libqhull_r/qhull_ra.h>
}
#endif

using namespace timestep;

namespace {

using Cloud = std::vector<Vec3>;

double largest_coordinate(const Cloud& cloud) {
  double most = 0;
  for (const Vec3& p : cloud)
    most = std::max(
        {most, double(std::abs(p.x)), double(std::abs(p.y)), double(std::abs(p.z))});
  return most;
}

// The highest of the points above any face
double highest(const ConvexHull& hull, const Cloud& cloud) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : hull.planes)
    for (const Vec3& p : cloud)
      most = std::max(most, glm::dot(glm::dvec3(plane.normal), glm::dvec3(p))
                                - double(plane.offset));
  return most;
}

// How far the corners of a face are from its plane
double unevenness(const ConvexHull& hull) {
  double most = 0;
  for (const HalfEdge& edge : hull.half_edges) {
    const Plane& plane = hull.planes[edge.face];
    const glm::dvec3 p(hull.vertices[edge.origin]);
    most = std::max(
        most, std::abs(glm::dot(glm::dvec3(plane.normal), p) - double(plane.offset)));
  }
  return most;
}

// What is wrong with the topology; nothing if all fits
std::string topology_fault(const ConvexHull& hull) {
  const auto& edges = hull.half_edges;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const HalfEdge& edge = edges[e];
    const HalfEdge& next = edges[edge.next];
    if (edges[edge.twin].twin != e) return "twins differ";
    if (edges[edge.twin].face == edge.face) return "a face beside itself";
    if (edges[edge.twin].origin != next.origin) return "a twin elsewhere";
    if (next.face != edge.face) return "an edge of another face";
    if (e < hull.face_start[edge.face] || e >= hull.face_start[edge.face + 1])
      return "an edge out of its face";
  }
  for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) {
    if (edges[hull.vertex_edge[v]].origin != v) return "an edge of another vertex";
    std::set<std::uint32_t> walked, listed;
    for (std::uint32_t i = hull.first_neighbour[v]; i < hull.first_neighbour[v + 1];
         ++i)
      walked.insert(hull.neighbours[i]);
    for (const HalfEdge& edge : edges)
      if (edge.origin == v) listed.insert(edges[edge.next].origin);
    if (walked != listed) return "other neighbours";
    if (walked.size() < 3) return "a vertex of two edges";
  }
  for (std::size_t f = 0; f < hull.planes.size(); ++f)
    if (hull.face_start[f + 1] < hull.face_start[f] + 3) return "a face of two edges";
  if (hull.vertices.size() + hull.planes.size() != edges.size() / 2 + 2)
    return "not a sphere";
  return "";
}

struct Check {
  double points_off, corners_off;  // in units of u L
};

// A hull that must exist, and by how much its points and corners are off
Check checked(const Cloud& cloud, const ConvexHull& hull) {
  REQUIRE(hull.vertices.size() >= 4);
  CHECK(topology_fault(hull).empty());
  const double unit = k_u * largest_coordinate(cloud);
  for (const Plane& plane : hull.planes)
    CHECK(std::abs(glm::length(plane.normal) - 1) < 4 * k_u);
  return {highest(hull, cloud) / unit, unevenness(hull) / unit};
}

ConvexHull hull_of(const Cloud& cloud) {
  HullResult result = convex_hull(cloud);
  INFO(result.fault);
  REQUIRE(result.fault.empty());
  return result.hull;
}

Cloud moved(Cloud cloud, const Mat3& by, const Vec3& to = Vec3(0)) {
  for (Vec3& p : cloud) p = by * p + to;
  return cloud;
}

// The vertices of a file, as they are
Cloud bunny() {
  std::ifstream file(TIMESTEP_MESHES "/bunny.obj");
  Cloud cloud;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    Vec3 p(0);
    if (words >> kind >> p.x >> p.y >> p.z && kind == "v") cloud.push_back(p);
  }
  return cloud;
}

// Points between -1 and 1: n along each axis
Cloud grid(int n) {
  Cloud cloud;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        cloud.push_back(Vec3(x, y, z) * (Real(2) / Real(n - 1)) - Vec3(1));
  return cloud;
}

#ifdef TIMESTEP_HAS_QHULL
struct Reference {
  double volume = 0;
  std::set<std::array<double, 3>> vertices;
};

Reference qhull(const Cloud& cloud) {
  std::vector<double> numbers;
  for (const Vec3& p : cloud) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  qhT library;
  qhT* qh = &library;
  qh_zero(qh, stderr);
  std::string options = "qhull FA Pp";
  REQUIRE(qh_new_qhull(qh, 3, int(cloud.size()), numbers.data(), False, options.data(),
                       nullptr, stderr)
          == 0);
  Reference reference;
  reference.volume = qh->totvol;
  for (vertexT* v = qh->vertex_list; v != nullptr && v->next != nullptr; v = v->next)
    reference.vertices.insert({v->point[0], v->point[1], v->point[2]});
  qh_freeqhull(qh, qh_ALL);
  int left = 0, blocks = 0;
  qh_memfreeshort(qh, &left, &blocks);
  return reference;
}

std::set<std::array<double, 3>> vertex_set(const ConvexHull& hull) {
  std::set<std::array<double, 3>> vertices;
  for (const Vec3& v : hull.vertices) vertices.insert({v.x, v.y, v.z});
  return vertices;
}
#endif

}  // namespace

TEST_CASE("the side of a plane is never wrong") {
  // Points of a plane in integers, scaled so that differences round; then one lifted by
  // the least that there is
  Random random(1);
  int on = 0, above = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto integer = [&] { return std::round(random.between(-1e4, 1e4)); };
    const glm::dvec3 a(integer(), integer(), integer());
    const glm::dvec3 u(integer(), integer(), integer());
    const glm::dvec3 v(integer(), integer(), integer());
    const double s = std::round(random.between(-50, 50));
    const double t = std::round(random.between(-50, 50));
    const glm::dvec3 n = glm::cross(u, v);
    if (n.z == 0) continue;
    glm::dvec3 p = a + s * u + t * v;
    const auto side = [&](double k) {
      return side_of_plane(k * a, k * (a + u), k * (a + v), k * p);
    };
    on += side(0x1p-120) == 0 && side(1) == 0;
    p.z = std::nextafter(p.z, n.z > 0 ? 1e9 : -1e9);
    above += side(0x1p-120) == 1 && side(1) == 1;
  }
  CHECK(on > 19000);
  CHECK(above == on);
}

TEST_CASE("a turned box has six faces, however thin it is and many points it has") {
  Random random(2);
  int thin_ones = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 size = random.sizes(1e-4, 1e4);
    const double thin = std::min({size.x, size.y, size.z});
    const double wide = std::max({size.x, size.y, size.z});
    if (thin < 4096 * k_u * wide) continue;
    thin_ones += thin < 1e-3 * wide;
    Mat3 by = matrix_of(random.turn());
    for (glm::length_t j = 0; j < 3; ++j) by[j] *= size[j] / 2;
    const Cloud cloud = moved(grid(2 + i % 4), by);
    const ConvexHull hull = hull_of(cloud);
    INFO(i << ", " << size.x << " x " << size.y << " x " << size.z);
    CHECK(hull.planes.size() == 6);
    CHECK(hull.vertices.size() == 8);
    const Check check = checked(cloud, hull);
    CHECK(check.points_off < 32);
    CHECK(check.corners_off < 32);

    // Vertices are off by 8 u wide; mesh_volume sums terms of wide^3 in a wider type
    const double exact = double(size.x) * size.y * size.z;
    const double wider = k_u < 1e-10 ? 0x1p-64 : 0x1p-53;
    CHECK(std::abs(hull.volume - exact)
          <= exact * 16 * k_u * wide / thin + 16 * wider * wide * wide * wide);
  }
  CHECK(thin_ones > 100);
}

TEST_CASE("points in a plane, on a line, in one place or not at all have no hull") {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  const auto fault = [](const Cloud& cloud) {
    const HullResult result = convex_hull(cloud);
    CHECK(result.hull.vertices.empty() == !result.fault.empty());
    return result.fault;
  };
  CHECK(fault({}) == "no points");
  CHECK(fault({Vec3(0)}) == "all points coincide");
  CHECK(fault(Cloud(1000000, Vec3(1, 2, 3))) == "all points coincide");
  CHECK(fault({Vec3(0), Vec3(1, 2, 3)}) == "all points are on a line");
  CHECK(fault({Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) == "all points are in a plane");
  CHECK(fault({Vec3(0), Vec3(1, nan, 0)}) == "point 1 is not finite");
  CHECK(fault({Vec3(0, 0, -infinity)}) == "point 0 is not finite");

  // Turned and shifted, so that rounding lifts the points off their line or plane
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Mat3 turn = matrix_of(random.turn()) * Real(random.log_between(1e-6, 1e6));
    const Vec3 shift = turn * random.in_cube(10);
    Cloud line, plane;
    for (int n = 0; n < 100; ++n) {
      line.push_back({0, 0, random.between(-1, 1)});
      plane.push_back({random.between(-1, 1), random.between(-1e-3, 1), 0});
    }
    CHECK(fault(moved(line, turn, shift)) == "all points are on a line");
    CHECK(fault(moved(plane, turn, shift)) == "all points are in a plane");
  }
}

TEST_CASE("no cloud is too hard") {
  // Lattices squeezed, sheared, shifted, with copies, and points within a few roundings
  // of each other: most sit in planes, lines or places that they nearly share
  Random random(4);
  int flat = 0;
  double points_off = 0, corners_off = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto scale = Real(random.log_between(1e-6, 1e6));
    const Vec3 squeeze = random.sizes(1e-5, 1);
    Mat3 by = matrix_of(random.turn());
    if (i % 2 == 0) by[0] += by[1] * Real(random.between(-1, 1));
    for (glm::length_t j = 0; j < 3; ++j) by[j] *= squeeze[j] * scale;
    const Vec3 shift =
        i % 3 == 0 ? Vec3(0) : scale * random.in_cube(i % 3 == 1 ? 1 : 1e3);
    Cloud cloud = moved(grid(2 + i % 5), by, shift);
    const std::size_t n = cloud.size();
    for (std::size_t j = 0; j < n; ++j) {
      const Vec3 noise = random.in_cube(random.log_between(0.1, 1e4));
      cloud.push_back(cloud[j] + cloud[j] * noise * Real(k_u));
    }
    const HullResult result = convex_hull(cloud);
    flat += !result.fault.empty();
    if (!result.fault.empty()) continue;
    INFO(i);
    const Check check = checked(cloud, result.hull);
    points_off = std::max(points_off, check.points_off);
    corners_off = std::max(corners_off, check.corners_off);
  }
  INFO("points " << points_off << ", corners " << corners_off << ", flat " << flat);
  CHECK(points_off < 32);
  CHECK(corners_off < 32);
  CHECK(flat < 600);
}

#ifdef TIMESTEP_HAS_QHULL
TEST_CASE("libqhull finds the same hulls") {
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    // In a ball, on a sphere, or in a cube; some far away, some needles
    const double scale = random.log_between(1e-6, 1e6);
    const Vec3 shift = i % 5 == 0 ? Vec3(Real(scale) * 100) : Vec3(0);
    const double needle = i % 7 == 0 ? 1e-3 : 1;
    Cloud cloud;
    for (int n = 4 + i; n > 0; --n) {
      Vec3 p = i % 3 == 0 ? random.direction() : random.in_cube();
      if (i % 3 == 1) p = random.direction() * Real(std::cbrt(random.between(0, 1)));
      p.x *= Real(needle);
      cloud.push_back(p * Real(scale) + shift);
    }
    const ConvexHull hull = hull_of(cloud);
    const Reference reference = qhull(cloud);
    INFO(i << ": " << cloud.size() << " points, scale " << scale);

    // What is merged, or not, is thinner than 32 u L
    const double off = 32 * k_u * largest_coordinate(cloud);
    const double area = surface_area(hull.vertices, hull_triangles(hull));
    CHECK(std::abs(hull.volume - reference.volume) <= off * area);
    if (k_u < 1e-10) CHECK(vertex_set(hull) == reference.vertices);
    const Check check = checked(cloud, hull);
    CHECK(check.points_off < 32);
    CHECK(check.corners_off < 32);
  }
}
#endif

TEST_CASE("the bunny's hull") {
  const Cloud cloud = bunny();
  REQUIRE(cloud.size() > 1000);
  const ConvexHull hull = hull_of(cloud);
  const Check check = checked(cloud, hull);
  CHECK(check.points_off < 32);
  CHECK(check.corners_off < 32);
  CHECK(mesh_fault(hull.vertices, hull_triangles(hull)).empty());
#ifdef TIMESTEP_HAS_QHULL
  const Reference reference = qhull(cloud);
  CHECK(hull.volume == Approx(reference.volume).epsilon(1e4 * k_u));
  CHECK(vertex_set(hull) == reference.vertices);
#endif
}

TEST_CASE("a support vertex found uphill is the highest of all") {
  Random random(6);
  for (int i = 0; i < 60; ++i) {
    Cloud cloud;
    for (int n = 0; n < 20 + 20 * i; ++n)
      cloud.push_back(random.direction() * Vec3(1, random.log_between(1e-3, 1), 1));
    const ConvexHull hull = hull_of(cloud);
    const HullShape shape = hull_shape(hull);
    std::uint32_t start = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec3 d = random.direction();
      start = support_vertex(shape, d, start);
      double most = -10;
      for (const Vec3& v : hull.vertices) most = std::max(most, double(glm::dot(v, d)));
      CHECK(most - glm::dot(hull.vertices[start], d) <= 16 * k_u);
    }
  }
}

TEST_CASE("a hull is the same whatever order its points are in") {
  Random random(7);
  Cloud cloud;
  for (int n = 0; n < 500; ++n) cloud.push_back(random.in_cube());
  const ConvexHull hull = hull_of(cloud);
  for (int i = 0; i < 20; ++i) {
    for (std::size_t n = cloud.size() - 1; n > 0; --n)
      std::swap(cloud[n], cloud[random.bits() % (n + 1)]);
    const ConvexHull other = hull_of(cloud);
    CHECK(other.vertices.size() == hull.vertices.size());
    CHECK(other.planes.size() == hull.planes.size());
    CHECK(other.volume == Approx(hull.volume).epsilon(16 * k_u));
  }
}
