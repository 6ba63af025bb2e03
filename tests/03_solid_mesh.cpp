// Mesh files as rigid bodies: those that come with Timestep, and whatever else a user
// may have. Compiled for each precision; u (k_u) is the unit round-off of the one at
// hand.
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "chapters/03-rigid-bodies/solid_mesh.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/resource_manager.hpp"
#include "common/physics/mesh_mass.hpp"
#include "tests/catch.hpp"
#include "tests/graphics_paths.hpp"

using namespace timestep;
using chapter_03::load_solid;
using chapter_03::SolidMesh;

namespace {

constexpr double k_u = std::numeric_limits<Real>::epsilon() / 2;
constexpr double k_u_float = 0x1p-24;  // drawn meshes are float whatever Real is

std::string asset(const std::string& name) {
  const std::ifstream file(find_asset("meshes", name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  REQUIRE(text.str().size() > 100);
  return text.str();
}

// The line with which a file is refused; nothing if it is not
std::optional<std::string> refusal(const std::filesystem::path& file,
                                   bool fix_winding = false) {
  try {
    const SolidMesh solid = load_solid(file, 1000, fix_winding);
    CHECK(solid.moments.x > 0);
    CHECK(is_inertia(solid.properties.inertia));
    return std::nullopt;
  } catch (const InputError& error) {
    const std::string line = error.what();
    CHECK(line.find("mesh " + file.string() + ": ") == 0);
    CHECK(line.find_first_of("\r\n") == std::string::npos);
    return line;
  }
}

bool refused_for(const std::filesystem::path& file, const std::string& fault) {
  const std::optional<std::string> line = refusal(file);
  INFO(line.value_or("it is taken"));
  const bool right = line && line->find(fault) != std::string::npos;
  CHECK(right);
  return right;
}

// A text's lines with one of them changed, or left out if `change` returns nothing
template <typename Change>
std::string edited(const std::string& text, Change change) {
  std::istringstream lines(text);
  std::string result, line;
  for (int n = 0; std::getline(lines, line); ++n)
    if (const std::optional<std::string> kept = change(line, n)) result += *kept + "\n";
  return result;
}

// Every face of an OBJ file that has no normals, wound the other way
std::string inside_out(const std::string& obj) {
  return edited(obj, [](const std::string& line, int) -> std::optional<std::string> {
    std::istringstream words(line);
    std::string f, a, b, c;
    words >> f >> a >> b >> c;
    return f == "f" ? "f " + a + " " + c + " " + b : line;
  });
}

struct Expected {
  const char* file;
  double volume;
  glm::dvec3 centre, moments;  // of density 1
};

// Exact sums over the floats in the files, as rationals; then rounded
constexpr double k_density = 7850;
const Expected k_bunny{
    "bunny.obj",
    0.0007958051910149861,
    {-0.003781621013134597, 0.05421960551870726, 0.012972785465772534},
    {8.428458687693567e-07, 1.5778792754433257e-06, 1.7596490173135204e-06}};
const Expected k_wrench{
    "wrench.obj",
    3.1809835357645084e-05,
    {0.10825188296503448, 0, 0.0004197852207758587},
    {3.2139115467887767e-09, 1.6594369177816555e-07, 1.687135124000523e-07}};

}  // namespace

TEST_CASE("the bunny and the wrench weigh what they should") {
  if (!can_load_meshes()) return;
  for (const Expected& expected : {k_bunny, k_wrench}) {
    INFO(expected.file);
    const SolidMesh solid = load_solid(expected.file, k_density, false);
    const MassProperties& body = solid.properties;
    CHECK(body.mass == Approx(k_density * expected.volume).epsilon(4 * k_u));

    // In double the sums are long double's, from vertices 0.2 m off at most
    CHECK(glm::distance(glm::dvec3(body.centre_of_mass), expected.centre)
          < 2 * k_u * 0.2);

    // Up to 9 turns of the axes round 3 times each
    for (int i = 0; i < 3; ++i)
      CHECK(std::abs(solid.moments[i] - k_density * expected.moments[i])
            <= 32 * k_u * k_density * expected.moments.z);
    CHECK(solid.notices.empty());
  }
}

TEST_CASE("a solid is drawn in the frame of its principal axes") {
  if (!can_load_meshes()) return;
  for (const Expected& expected : {k_bunny, k_wrench}) {
    const SolidMesh solid = load_solid(expected.file, 1, false);
    const MeshData& drawn = *solid.mesh;
    const std::vector<Vec3> vertices(drawn.positions.begin(), drawn.positions.end());
    const MassProperties again = mesh_mass(1, vertices, drawn.triangles);

    // Vertices are rounded to floats, 0.15 m or less from the middle: that moves the
    // surface, and volume by up to area u 0.15 m
    const double area = surface_area(vertices, drawn.triangles);
    const double moved = 4 * k_u_float * 0.15;
    CHECK(std::abs(again.mass - expected.volume) < area * moved);
    CHECK(glm::length(again.centre_of_mass) < 0.15 * area * moved / expected.volume);
    Mat3 principal(0);
    for (int i = 0; i < 3; ++i) principal[i][i] = solid.moments[i];
    for (int i = 0; i < 3; ++i)
      CHECK(glm::distance(again.inertia[i], principal[i]) < 0.15 * 0.15 * area * moved);

    // The file's frame again
    const MeshData file = load_mesh(find_asset("meshes", expected.file));
    double furthest = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 back =
          solid.file_from_body * vertices[i] + solid.properties.centre_of_mass;
      furthest =
          std::max(furthest, double(glm::distance(back, Vec3(file.positions[i]))));
    }
    CHECK(furthest < 16 * k_u_float * 0.25);
  }
}

TEST_CASE("a mesh that is inside out is refused, or turned and that is said") {
  if (!can_load_meshes()) return;
  const ScratchFolder folder;
  const auto file = folder.write("in.obj", inside_out(asset("bunny.obj")));
  refused_for(file, "in.obj: inside out: volume -0.000796 m³; try --fix-winding");

  const SolidMesh turned = load_solid(file, 1, true);
  const SolidMesh bunny = load_solid("bunny.obj", 1, true);
  REQUIRE(turned.notices.size() == 1);
  CHECK(turned.notices[0].find("in.obj: was inside out") != std::string::npos);
  CHECK(bunny.notices.empty());
  CHECK(turned.moments == bunny.moments);

  // The normals point outwards again, or the light would fall on the wrong side
  const MeshData& mesh = *turned.mesh;
  double outwards = 0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    outwards += glm::dot(mesh.normals[i], mesh.positions[i]);
  CHECK(mesh.normals.size() == mesh.positions.size());
  CHECK(outwards > 0);
}

TEST_CASE("broken meshes are refused in one line that names the fault") {
  if (!can_load_meshes()) return;
  const ScratchFolder folder;
  const std::string bunny = asset("bunny.obj");
  const auto file = [&](const std::string& text) {
    return folder.write("b.obj", text);
  };
  const auto without = [&](int first, int last) {
    int face = 0;
    return edited(bunny, [&](const std::string& line, int) {
      const bool out = line[0] == 'f' && ++face >= first && face <= last;
      return out ? std::nullopt : std::optional(line);
    });
  };
  CHECK(!refusal(file(bunny)));
  refused_for(file(without(1, 1)), "b.obj: not closed: 3 boundary edges");
  refused_for(file(without(3663, 3674)), "not closed: 22 boundary edges");
  refused_for(file(bunny + "f 1 2 3\n"), "not closed: 1 boundary edge");
  refused_for(file(bunny + "f 1 1 2\n"), "1 triangle without area");

  const std::string last_face = bunny.substr(bunny.rfind("f "));
  refused_for(file(bunny + last_face), "3 edges with more than two triangles");
  refused_for(file("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), "no volume");

  // Two tetrahedra that share an edge, and one with a face the wrong way round
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
  CHECK(!refusal(file(points + faces + "f 2 3 4\n")));
  refused_for(file(points + faces + "f 2 4 3\n"), "3 edges between opposite windings");
}

TEST_CASE("files that are no meshes are refused") {
  if (!can_load_meshes()) return;
  const ScratchFolder folder;
  refused_for(folder.path() / "none.obj", "there is no such file");
  refused_for(folder.path(), "is a folder");
  refused_for(folder.write("empty.obj", ""), "is empty");
  refused_for(folder.write("text.obj", "Dear reader,\nthis is no mesh.\n"), "");
  refused_for(folder.write("text.xyz", "Dear reader,\nthis is no mesh.\n"), "");
  refused_for(folder.write("cut.glb", std::string("glTF\2\0\0\0\xff\0\0\0", 12)), "");
  refused_for(folder.write("cut.gltf", asset("tetrahedron.gltf").substr(0, 400)), "");

  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  for (const char* bad : {"v nan 0 0\n", "v 0 inf 0\n", "v 1e999 0 0\n"})
    refused_for(folder.write("nan.obj", fmt::format("{}{}{}", bad, points, faces)), "");
  refused_for(folder.write("index.obj", points + faces + "f 1 2 4000000000\n"), "");
  refused_for(folder.write("index.obj", points + faces + "f 1 2 99\n"), "");
  refused_for(folder.write("tiny.obj",
                           "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\n"
                           "v 0 0 1e-30\n"
                               + faces),
              "");
}

TEST_CASE("a file that is cut or scrambled anywhere is taken or refused, not worse") {
  if (!can_load_meshes()) return;
  const ScratchFolder folder;
  const std::string wrench = asset("wrench.obj");
  int refused = 0;
  constexpr int k_cuts = 24;
  for (int i = 1; i < k_cuts; ++i) {
    const std::string start = wrench.substr(0, wrench.size() * std::size_t(i) / k_cuts);
    refused += refusal(folder.write("cut.obj", start)).has_value();
  }
  CHECK(refused == k_cuts - 1);

  // What is scrambled may still be a mesh: of another shape, or in a comment
  std::mt19937 random(3);
  for (int i = 0; i < 48; ++i) {
    std::string text = wrench;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = char(random() % 128);
    refusal(folder.write("scrambled.obj", text));
  }
}
