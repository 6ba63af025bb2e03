// The renderer as it draws: where things land, shadows, text, resources given and
// returned. Compares places and differences, never one driver's pixels.

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <imgui.h>

#include "common/graphics/frame.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/object.hpp"
#include "common/graphics/offscreen_context.hpp"
#include "common/graphics/palette.hpp"
#include "common/graphics/renderer.hpp"
#include "common/graphics/window.hpp"
#include "tests/catch.hpp"
#include "tests/graphics_paths.hpp"

using namespace timestep;

namespace {

constexpr glm::ivec2 k_size{480, 270};
constexpr Color k_red{0.9F, 0.05F, 0.05F, 1};

/// A context and a renderer, for a picture of `size`.
struct Studio {
  explicit Studio(glm::ivec2 picture = k_size)
      : size(picture), context(size.x, size.y), renderer(resources) {}

  Image draw(const DrawList& list, const CameraPose& pose = {}) {
    context.begin();
    renderer.draw(list, Camera(pose), size);
    return context.read();
  }

  glm::ivec2 size;
  OffscreenContext context;
  ResourceManager resources;
  Renderer renderer;
};

glm::ivec3 pixel_at(const Image& image, glm::vec2 place) {
  const int x = std::clamp(static_cast<int>(place.x), 0, image.width - 1);
  const int y = std::clamp(static_cast<int>(place.y), 0, image.height - 1);
  const auto i = static_cast<std::size_t>(4 * (y * image.width + x));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

bool is_red(glm::ivec3 c) {
  return c.r > 2 * c.g && c.r > 2 * c.b && c.r > 60;
}

int brightness(glm::ivec3 c) {
  return c.r + c.g + c.b;
}

/// The centre and the number of the pixels that pass.
struct Blob {
  glm::vec2 center{0};
  int count = 0;
};

Blob find_blob(const Image& image, const std::function<bool(glm::ivec3)>& passes) {
  Blob blob;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!passes(pixel_at(image, {x, y}))) continue;
      blob.center += glm::vec2(x, y) + 0.5F;
      ++blob.count;
    }
  }
  blob.center /= std::max(blob.count, 1);
  return blob;
}

int count_different(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const int change = std::abs(a.rgba[i] - b.rgba[i])
                       + std::abs(a.rgba[i + 1] - b.rgba[i + 1])
                       + std::abs(a.rgba[i + 2] - b.rgba[i + 2]);
    if (change > 24) ++count;
  }
  return count;
}

DrawList empty_scene() {
  DrawList list;
  list.ground_height.reset();
  return list;
}

glm::mat4 placed(glm::vec3 center, float size) {
  return glm::scale(glm::translate(glm::mat4(1), center), glm::vec3(size));
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("things land where the projection says") {
  Studio studio;
  const CameraPose pose{{0.2F, 0.9F, -0.3F}, 7, 0.6F, 0.35F, 0.7F};
  const glm::vec3 place{1.1F, 1.7F, 0.4F};
  const glm::vec2 expected = *Camera(pose).project(place, studio.size);

  DrawList point = empty_scene(), ball = point, sphere = point, marker = point;
  point.balls.push_back({place, 0.05F, k_red});
  ball.balls.push_back({place, 0.3F, k_red});
  sphere.shapes.push_back({ShapeKind::sphere, placed(place, 0.1F), k_red});
  marker.markers.push_back({place, {k_red, MarkerShape::square, Dash::solid}, 12});
  for (const DrawList& list : {point, ball, sphere, marker}) {
    const Blob blob = find_blob(studio.draw(list, pose), is_red);
    REQUIRE(blob.count > 4);
    REQUIRE(glm::distance(blob.center, expected) < 1);
  }
}

TEST_CASE("a line runs between its ends' pixels") {
  Studio studio;
  DrawList list = empty_scene();
  const glm::vec3 a{-1.5F, 0.5F, 0}, b{1.5F, 1.8F, 0.5F};
  list.lines.push_back({{a, b}, k_red, 3, Dash::solid, false});
  const Image image = studio.draw(list);
  const Camera camera{CameraPose{}};
  const glm::vec2 from = *camera.project(a, studio.size),
                  to = *camera.project(b, studio.size);
  for (const float share : {0.05F, 0.3F, 0.5F, 0.8F, 0.95F}) {
    REQUIRE(is_red(pixel_at(image, glm::mix(from, to, share))));
  }
  REQUIRE_FALSE(is_red(pixel_at(image, glm::mix(from, to, 0.5F) + glm::vec2(0, 9))));

  // Dashes leave something out, and a fading line starts with nothing
  const int whole = find_blob(image, is_red).count;
  list.lines[0].dash = Dash::dashed;
  REQUIRE(find_blob(studio.draw(list), is_red).count < 0.8 * whole);
  list.lines[0] = {{a, b}, k_red, 3, Dash::solid, true};
  REQUIRE_FALSE(is_red(pixel_at(studio.draw(list), glm::mix(from, to, 0.02F))));
}

TEST_CASE("very many balls are all drawn") {
  Studio studio;
  DrawList list = empty_scene();
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 16; ++j) {
      const glm::vec3 center{0.14F * static_cast<float>(i) - 2.2F,
                             0.14F * static_cast<float>(j), 0};
      list.balls.push_back({center, 0.05F, k_red});
    }
  }
  const Image image = studio.draw(list);
  for (const Ball& ball : list.balls) {
    const auto place = Camera(CameraPose{}).project(ball.center, studio.size);
    REQUIRE(is_red(pixel_at(image, *place)));
  }
}

TEST_CASE("what is nearer hides what is farther") {
  Studio studio;
  const glm::vec3 near_eye{0, 1.4F, 2};
  for (const bool large : {false, true}) {
    DrawList list = empty_scene();
    list.shapes.push_back({ShapeKind::box, placed({0, 1, -1}, 0.8F), k_red});
    list.balls.push_back({near_eye, large ? 0.5F : 0.08F, {0, 0.3F, 0.9F, 1}});
    const glm::vec2 place = *Camera(CameraPose{}).project(near_eye, studio.size);
    REQUIRE_FALSE(is_red(pixel_at(studio.draw(list), place)));

    list.balls[0].center.z = -4;
    const glm::vec2 behind =
        *Camera(CameraPose{}).project(list.balls[0].center, studio.size);
    REQUIRE(is_red(pixel_at(studio.draw(list), behind)));
  }
}

TEST_CASE("shadows fall on the side away from the light") {
  Studio studio;
  const CameraPose pose{{0, 0.5F, 0}, 8, 0, 0.7F, 0.7F};
  const glm::vec3 center{0, 1.2F, 0};
  DrawList with_point, with_ball, with_box;
  with_point.balls.push_back({center, 0.12F, k_body});
  with_ball.balls.push_back({center, 0.6F, k_body});
  with_box.shapes.push_back({ShapeKind::box, placed(center, 0.3F), k_body});
  const Image bare = studio.draw({}, pose);

  for (const DrawList& list : {with_point, with_ball, with_box}) {
    const Image image = studio.draw(list, pose);
    const glm::vec3 light = light_for(list, pose, 1024).toward_light;
    const glm::vec3 shaded = center - light * (center.y / light.y);
    const glm::vec3 mirrored{-shaded.x, 0, -shaded.z};
    const auto change = [&](glm::vec3 world) {
      const glm::vec2 place = *Camera(pose).project(world, studio.size);
      return brightness(pixel_at(bare, place)) - brightness(pixel_at(image, place));
    };
    REQUIRE(change(shaded) > 30);
    REQUIRE(std::abs(change(mirrored)) < 10);
  }
}

TEST_CASE("text leaves ink where it belongs, larger in a larger picture") {
  const auto ink_of = [](glm::ivec2 size, const DrawList& list) {
    Studio studio(size);
    const Image image = studio.draw(list);
    return find_blob(image, [](glm::ivec3 c) { return brightness(c) < 250; });
  };
  DrawList title = empty_scene();
  REQUIRE(ink_of({640, 480}, title).count == 0);
  title.title = "Energy ½mv²";
  const Blob small = ink_of({640, 480}, title);
  REQUIRE(small.count > 100);
  REQUIRE(small.center.x < 200);
  REQUIRE(small.center.y < 60);
  const Blob large = ink_of({1280, 960}, title);
  REQUIRE(large.count > 3 * small.count);
  REQUIRE(large.count < 6 * small.count);

  DrawList label = empty_scene();
  label.labels.push_back({{1, 1, 0}, "here", k_ink});
  const glm::vec2 place = *Camera(CameraPose{}).project({1, 1, 0}, {640, 480});
  const Blob word = ink_of({640, 480}, label);
  REQUIRE(word.count > 10);
  REQUIRE(glm::distance(word.center, place) < 50);
}

TEST_CASE("charts are drawn in the lower right corner, failed series included") {
  Studio studio({960, 540});
  const Image bare = studio.draw({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const bool logarithmic : {false, true}) {
    DrawList list;
    list.charts.push_back({"Error", "t [s]", "e [m]", logarithmic, {}});
    list.charts[0].series = {
        {"ok", method_style(0), {{0, 1e-3}, {1, 0.5}, {2, 3}}},
        {"fails", method_style(1), {{0, 1}, {0.5, nan}, {0.7, infinite}, {1, -2}}},
        {"", method_style(2), {}}};
    const Image image = studio.draw(list);
    REQUIRE(count_different(bare, image) > 1000);
    const glm::ivec3 panel = pixel_at(image, {930, 505});
    REQUIRE(brightness(panel) > 690);
  }
}

TEST_CASE("broken numbers and places behind the eye do no harm") {
  Studio studio;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  DrawList list;
  for (const float bad : {nan, infinite, 1e30F, 1e-40F}) {
    list.balls.push_back({{bad, 0, 0}, 1, k_red});
    list.balls.push_back({{0, 0, 0}, bad, k_red});
    list.shapes.push_back({ShapeKind::box, placed({bad, 0, 0}, bad), k_red});
    list.lines.push_back(
        {{{0, 0, 0}, {bad, 1, 0}, {0, 0, 99}}, k_red, 2, Dash::solid, true});
    list.arrows.push_back({{0, bad, 0}, {0, 0, 99}, k_red, 4});
    list.markers.push_back({{0, 0, bad}, {}, 12});
    list.labels.push_back({{0, bad, 99}, "\xFF?", k_red});
  }
  list.lines.push_back({{}, k_red, 2, Dash::solid, false});
  list.lines.push_back({{{0, 0, 0}}, k_red, 2, Dash::dotted, true});
  REQUIRE_NOTHROW(studio.draw(list));
  REQUIRE_NOTHROW(studio.draw(list, {{0, nan, 0}, 0, nan, 0, 0}));

  // A line from behind the eye to in front of it still shows its visible part
  DrawList through = empty_scene();
  through.lines.push_back({{{0, 1, 0}, {0.5F, 0, 60}}, k_red, 4, Dash::solid, false});
  REQUIRE(find_blob(studio.draw(through), is_red).count > 20);
}

TEST_CASE("setting up a scene is as short as in the thesis") {
  OffscreenContext context(320, 240);
  context.begin();
  if (!can_load_meshes()) return;

  ResourceManager resources;
  const Camera camera({0, 3, 7}, {0, -0.4F, -1});

  const Shader& shader = resources.load_shader("minimal.vert", "minimal.frag");
  shader.set("projection", camera.projection(320.0F / 240));
  shader.set("view", camera.view());

  const Object cube{&resources.load_model("cube.obj", shader)};
  cube.draw();

  const Image image = context.read();
  const Blob blob = find_blob(image, [](glm::ivec3 c) { return c.b < c.r; });
  REQUIRE(blob.count > 500);
  const glm::vec2 middle = *camera.project({0, 0, 0}, {320, 240});
  REQUIRE(glm::distance(blob.center, middle) < 10);
}

TEST_CASE("the same file is loaded once") {
  OffscreenContext context(64, 64);
  ResourceManager resources;
  const Shader& shader = resources.load_shader("minimal.vert", "minimal.frag");
  REQUIRE(&shader == &resources.load_shader("minimal.vert", "minimal.frag"));
  REQUIRE(&resources.load_texture("checker.png")
          == &resources.load_texture("checker.png"));
  if (can_load_meshes()) {
    REQUIRE(&resources.load_model("cube.obj", shader)
            == &resources.load_model("cube.obj", shader));
  }

  // A mesh in memory stays as long as somebody holds it
  const auto data = std::make_shared<const MeshData>(
      MeshData{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {{0, 1, 2}}});
  REQUIRE(&resources.mesh(data) == &resources.mesh(data));
}

TEST_CASE("faults of files are one line") {
  OffscreenContext context(64, 64);
  ResourceManager resources;
  const ScratchFolder folder;
  const auto has = [](const std::string& line, const std::string& words) {
    INFO(line);
    return line.find(words) != std::string::npos
           && line.find('\n') == std::string::npos;
  };
  const auto shader_fault = [&](const std::string& fragment) {
    const auto file = folder.write("broken.frag", fragment);
    return refusal([&] { resources.load_shader("minimal.vert", file.string()); });
  };
  REQUIRE(has(shader_fault("#version 330 core\n\nvoid main() { nothing(); }\n"),
              "broken.frag:3:"));
  REQUIRE(has(shader_fault("#version 330 core\n#include \"lighting.glsl\"\nout int a;\n"
                           "void main() { a = 1.5 * ; }\n"),
              "broken.frag:4:"));
  REQUIRE(has(refusal([&] { resources.load_shader("none.vert", "minimal.frag"); }),
              "none.vert: there is no such file"));
  REQUIRE(has(refusal([&] { resources.load_texture("none.png"); }), "none.png"));
  const Shader& shader = resources.load_shader("minimal.vert", "minimal.frag");
  REQUIRE(has(refusal([&] { resources.load_model("none.obj", shader); }), "none.obj"));
}

TEST_CASE("contexts come and go, several times and together") {
  for (int i = 0; i < 2; ++i) {
    Studio studio({64, 48});
    REQUIRE(studio.draw({}).rgba.size() == std::size_t{4} * 64 * 48);
  }
  Studio one({32, 32});
  {
    Studio other({48, 48});
    REQUIRE(other.draw({}).width == 48);
    one.context.begin();
    other.context.begin();
  }
  one.context.begin();
  REQUIRE(one.draw({}).width == 32);
}

TEST_CASE("impossible sizes are refused in one line") {
  for (const auto& [width, height] :
       {std::pair{0, 10}, {10, -1}, {1 << 30, 8}, {8, 1 << 30}}) {
    const std::string line =
        refusal([w = width, h = height] { OffscreenContext(w, h).begin(); });
    REQUIRE(line.find("no off-screen OpenGL: ") == 0);
    REQUIRE(line.find('\n') == std::string::npos);
  }
  OffscreenContext tiny(1, 1, 0);
  tiny.begin();
  REQUIRE(tiny.read().rgba.size() == 4);
}

TEST_CASE("panels are drawn without a window, and leave no settings file") {
  Studio studio;
  const Image bare = studio.draw({});
  studio.context.begin();
  studio.renderer.draw({}, Camera(CameraPose{}), studio.size);
  for (const float scale : {1.0F, 1.5F}) {
    studio.renderer.begin_ui(studio.size, scale);
    ImGui::SetNextWindowPos({20, 20});
    ImGui::SetNextWindowSize({200, 100});
    ImGui::Begin("dt → θ");
    ImGui::TextUnformatted("words");
    ImGui::End();
    studio.renderer.end_ui();
  }
  REQUIRE(count_different(bare, studio.context.read()) > 500);
  REQUIRE_FALSE(std::filesystem::exists("imgui.ini"));
}

TEST_CASE("off-screen drawing needs no display, a window does") {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(name);
  REQUIRE(Studio({64, 48}).draw({}).width == 64);
  REQUIRE_FALSE(Window::display_available());
  const std::string line = refusal([] { Window("none", 64, 64); });
  REQUIRE(line.find("no window: ") == 0);
  REQUIRE(line.find('\n') == std::string::npos);
}
