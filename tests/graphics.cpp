// The renderer without OpenGL: camera, palette, axes, text decoding, files and their
// faults.

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "common/graphics/apart.hpp"
#include "common/graphics/axis.hpp"
#include "common/graphics/camera.hpp"
#include "common/graphics/font.hpp"
#include "common/graphics/image.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/graphics/primitives.hpp"
#include "common/graphics/resource_manager.hpp"
#include "tests/catch.hpp"
#include "tests/graphics_paths.hpp"

using namespace timestep;

namespace {

bool near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5F) {
  return glm::distance(a, b) <= tolerance;
}

/// The one line with which `action` refuses; empty if it does not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Refused in one line that names the file and holds these words.
bool refused_naming(const std::string& line, const std::string& file,
                    const std::string& words) {
  return line.find(file) != std::string::npos && line.find(words) != std::string::npos
         && line.find('\n') == std::string::npos;
}

double volume(const MeshData& mesh) {
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six +=
        glm::dot(mesh.positions[a], glm::cross(mesh.positions[b], mesh.positions[c]));
  }
  return six / 6;
}

}  // namespace

TEST_CASE("the camera stands where its pose says") {
  const CameraPose pose{{1, 2, 3}, 5, 0, 0, 0.7F};
  REQUIRE(near(Camera(pose).position(), {1, 2, 8}));

  CameraPose turned = pose;
  turned.yaw = glm::half_pi<float>();
  REQUIRE(near(Camera(turned).position(), {6, 2, 3}));

  CameraPose raised = pose;
  raised.pitch = glm::quarter_pi<float>();
  const float side = 5 / std::sqrt(2.0F);
  REQUIRE(near(Camera(raised).position(), {1, 2 + side, 3 + side}));
}

TEST_CASE("the view puts the target ahead and the eye at the origin") {
  const Camera camera({{0.3F, -1, 2}, 4, 0.8F, -0.4F, 0.7F});
  const glm::mat4 view = camera.view();
  REQUIRE(near(view * glm::vec4(camera.position(), 1), {0, 0, 0}));
  REQUIRE(near(view * glm::vec4(camera.pose().target, 1), {0, 0, -4}));

  // A rotation: lengths and handedness stay
  const glm::mat3 rotation(view);
  REQUIRE(glm::determinant(rotation) == Approx(1).epsilon(1e-5));
}

TEST_CASE("a camera from position and direction looks along it") {
  const Camera camera({0, 3, 7}, {0, -0.3F, -1});
  REQUIRE(near(camera.position(), {0, 3, 7}));
  const auto ahead = camera.project({0, 2.7F, 6}, {640, 480});
  REQUIRE(ahead);
  REQUIRE(glm::distance(*ahead, glm::vec2(320, 240)) < 1e-2F);
}

TEST_CASE("the perspective follows the closed form") {
  const CameraPose pose{{0, 0, 0}, 10, 0, 0, 0.9F};
  const glm::vec2 size{1280, 720};
  const float focal = size.y / 2 / std::tan(pose.vertical_fov / 2);

  const glm::vec3 world{1.5F, -2, 4};
  const float depth = 10 - world.z;
  const auto pixel = Camera(pose).project(world, size);
  REQUIRE(pixel);
  REQUIRE(pixel->x == Approx(640 + focal * world.x / depth).epsilon(1e-5));
  REQUIRE(pixel->y == Approx(360 - focal * world.y / depth).epsilon(1e-5));
}

TEST_CASE("nothing behind the eye has a pixel") {
  const Camera camera({{0, 0, 0}, 5, 0, 0, 0.7F});
  REQUIRE_FALSE(camera.project({0, 0, 6}, {640, 480}));
  REQUIRE_FALSE(camera.project({0, 0, std::nanf("")}, {640, 480}));
}

TEST_CASE("orbiting keeps the distance and stops before the poles") {
  const CameraPose start;
  const CameraPose turned = orbit(start, {360, 0}, 720);
  REQUIRE(turned.yaw == Approx(start.yaw - glm::half_pi<float>()));
  const auto far = glm::distance(Camera(turned).position(), turned.target);
  REQUIRE(far == Approx(start.distance));
  REQUIRE(orbit(start, {0, 1e6F}, 720).pitch < glm::half_pi<float>());
  REQUIRE(orbit(start, {0, -1e6F}, 720).pitch > -glm::half_pi<float>());
}

TEST_CASE("panning moves the target with the mouse") {
  const CameraPose start{{0.5F, 1, -2}, 6, 0.7F, 0.3F, 0.7F};
  const glm::vec2 size{1280, 720}, drag{37, -52};
  const CameraPose moved = pan(start, drag, size.y);
  const auto pixel = Camera(moved).project(start.target, size);
  REQUIRE(pixel);
  REQUIRE(glm::distance(*pixel, size / 2.0F + drag) < 0.01F);
}

TEST_CASE("zooming in and out again returns") {
  const CameraPose pose = zoom(zoom(CameraPose{}, 3), -3);
  REQUIRE(pose.distance == Approx(CameraPose{}.distance));
  REQUIRE(zoom(CameraPose{}, 1).distance < CameraPose{}.distance);
}

TEST_CASE("thirty-two methods differ in marker or in colour") {
  std::set<std::string> looks;
  for (int i = 0; i < 32; ++i) {
    const Style style = method_style(i);
    looks.insert(to_hex(style.color) + name(style.marker));
  }
  REQUIRE(looks.size() == 32);
}

TEST_CASE("eight methods differ in marker and in colour") {
  std::set<MarkerShape> markers;
  std::set<std::string> colors;
  for (int i = 0; i < 8; ++i) {
    markers.insert(method_style(i).marker);
    colors.insert(to_hex(method_style(i).color));
  }
  REQUIRE(markers.size() == 8);
  REQUIRE(colors.size() == 8);
  REQUIRE(method_style(32).marker == method_style(0).marker);
  REQUIRE(method_style(-1).marker == method_style(31).marker);
  REQUIRE(to_hex({1, 0.5F, 0, 0.2F}) == "#ff8000");
  REQUIRE(name(MarkerShape::diamond) == std::string("diamond"));
  REQUIRE(name(Dash::dotted) == std::string("dotted"));
}

TEST_CASE("axes hold their values and mark round numbers") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const Axis axis = axis_for({0.0, nan, 7.3, infinite}, false);
  REQUIRE(axis.low <= 0);
  REQUIRE(axis.high >= 7.3);
  REQUIRE(axis.high < 10);
  REQUIRE(ticks(axis, 4).size() >= 3);

  const Axis decades = axis_for({3e-7, 20, 0, -1}, true);
  REQUIRE(decades.low == Approx(1e-7));
  REQUIRE(decades.high == Approx(100));
  REQUIRE(decades.share(1e-7) == Approx(0).margin(1e-12));
  REQUIRE(ticks(decades, 4).front().text == "100");

  // Neither one value, nor none, nor the largest numbers leave an empty range
  for (const auto& values :
       {std::vector<double>{}, {5}, {-1e308, 1e308}, {0, 5e-324}}) {
    for (const bool logarithmic : {false, true}) {
      const Axis odd = axis_for(values, logarithmic);
      REQUIRE(odd.low < odd.high);
      REQUIRE(std::isfinite(odd.high - odd.low));
      REQUIRE(ticks(odd, 4).size() < 30);
    }
  }
}

TEST_CASE("UTF-8 is decoded, broken bytes are marked") {
  REQUIRE(decode_utf8("aθ²→") == U"aθ²→");
  REQUIRE(decode_utf8("\xFFz") == std::u32string{0xFFFD, U'z'});
  REQUIRE(decode_utf8("\xCE").size() == 1);
}

TEST_CASE("the unit shapes are closed and face outward") {
  const double pi = glm::pi<double>();
  REQUIRE(volume(unit_mesh(ShapeKind::box)) == Approx(8));
  REQUIRE(volume(unit_mesh(ShapeKind::sphere)) == Approx(4 * pi / 3).epsilon(0.02));
  REQUIRE(volume(unit_mesh(ShapeKind::cylinder)) == Approx(2 * pi).epsilon(0.01));
  REQUIRE(volume(unit_mesh(ShapeKind::cone)) == Approx(2 * pi / 3).epsilon(0.01));
}

TEST_CASE("images survive writing and reading") {
  const ScratchFolder folder;
  const Image image{2, 1, {255, 0, 10, 255, 1, 2, 3, 255}};
  write_png(image, folder.path() / "a.png");
  const Image again = load_image(folder.path() / "a.png");
  REQUIRE(again.width == 2);
  REQUIRE(again.height == 1);
  REQUIRE(again.rgba == image.rgba);
}

TEST_CASE("images that cannot be read or written are one line") {
  const ScratchFolder folder;
  const auto text = folder.write("text.png", "this is no picture");
  const auto empty = folder.write("empty.png", "");
  REQUIRE(refused_naming(refusal([&] { load_image(text); }), "text.png", ""));
  REQUIRE(refused_naming(refusal([&] { load_image(empty); }), "empty.png", ""));
  REQUIRE(refused_naming(refusal([&] { load_image("none.png"); }), "none.png",
                         "no such file"));
  REQUIRE(refused_naming(refusal([&] { load_image(folder.path()); }),
                         folder.path().string(), "no such file"));

  const auto nowhere = folder.path() / "no-folder" / "a.png";
  REQUIRE(refused_naming(refusal([&] {
                           write_png({1, 1, {0, 0, 0, 0}}, nowhere);
                         }),
                         "a.png", "cannot be written"));
  REQUIRE(refused_naming(refusal([&] {
                           write_png({1, 1, {0, 0, 0, 0}}, folder.path());
                         }),
                         folder.path().string(), "cannot be written"));
}

TEST_CASE("an image that the disk cannot hold is an error and leaves nothing") {
  const ScratchFolder folder;
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit few_bytes{.rlim_cur = 20, .rlim_max = usual.rlim_max};
  const auto on_full = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &few_bytes);
  CHECK_THROWS_AS(write_png({1, 1, {0, 0, 0, 0}}, folder.path() / "a.png"), InputError);
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, on_full);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("work done apart returns its bytes, and nothing if it fails") {
  const std::string bytes(1000000, '\0');
  CHECK(compute_apart([&] { return bytes; }, 10) == bytes);
  CHECK(compute_apart([]() -> std::string { std::abort(); }, 10) == std::nullopt);
  CHECK(compute_apart([]() -> std::string { throw InputError("no"); }, 10)
        == std::nullopt);
  const auto endless = []() -> std::string {
    for (;;) pause();
  };
  CHECK(compute_apart(endless, 1) == std::nullopt);
}

TEST_CASE("meshes are read from OBJ and glTF") {
  if (!can_load_meshes()) return;
  REQUIRE(std::abs(volume(load_mesh(find_asset("meshes", "cube.obj")))) == Approx(8));
  const MeshData tetrahedron = load_mesh(find_asset("meshes", "tetrahedron.gltf"));
  REQUIRE(tetrahedron.triangles.size() == 4);
  REQUIRE(volume(tetrahedron) == Approx(8.0 / 3));
  REQUIRE(volume(load_mesh(find_asset("meshes", "knot.obj"))) > 1);
}

TEST_CASE("broken mesh files are one line that names file and fault") {
  const ScratchFolder folder;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"empty.obj", ""},
      {"text.obj", "It was a dark and stormy night.\n"},
      {"text.txt", "It was a dark and stormy night.\n"},
      {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"inf.obj", "v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"},
      {"points.obj", "v 0 0 0\nv 1 0 0\n"},
      {"line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
      {"cut.gltf", R"({"asset":{"version":"2.0"},"meshes":[{)"},
      {"empty.gltf", "{}"},
      {"bytes.glb", std::string("glTF\x02\0\0\0\xFF\xFF\xFF\x7F", 12)},
  };
  for (const auto& [file, text] : files) {
    const auto path = folder.write(file, text);
    const std::string line = refusal([&] { load_mesh(path); });
    INFO(file << ": " << line);
    REQUIRE(refused_naming(line, file, ""));
  }
  REQUIRE(
      refused_naming(refusal([] { load_mesh("none.obj"); }), "none.obj", "no such"));
  REQUIRE(refused_naming(refusal([&] { load_mesh(folder.path()); }),
                         folder.path().string(), "folder"));
  if (can_load_meshes()) REQUIRE_NOTHROW(load_mesh(folder.write("ok.obj", triangle)));
}
