// A box in three planes at once: the corner of a room. No gravity.
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "chapters/05-penetration/parts.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

class Corner : public OverlapRun {
 public:
  explicit Corner(const Setup& setup);
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override { list.ground_height.reset(); }
};

// Straight out, by as much as it is in each: no plane's push turns the box, since it
// acts on a whole face
Corner::Corner(const Setup& setup)
    : OverlapRun(setup,
                 {.apart = {2.2F, 2.2F}, .columns = 3, .mark = {0.85F, 0.1F, 1.8F}}) {
  for (const int axis : {0, 1, 2}) {
    Vec3 normal(0);
    normal[axis] = 1;
    add_wall(normal, 0);
  }
  const glm::dvec3 out(size() / 2);
  const glm::dvec3 depth(parameter("depth_x"), parameter("depth_y"),
                         parameter("depth_z"));
  const double mass = parameter("mass");
  const Shape shape = Box{Vec3(out)};
  const RigidBody box = solid(mass, shape, {.position = out - size() * depth});
  add_body("box", box, shape, {.position = out});
}

// The walls, and the floor where others see the ground
void Corner::draw(DrawList& list) const {
  constexpr float k_wide = 1.7F, k_thin = 0.01F;
  for (const int axis : {0, 1, 2}) {
    glm::vec3 half(k_wide / 2), middle(k_wide / 2);
    half[axis] = k_thin;
    middle[axis] = -k_thin;
    const glm::vec3 at = picture({origin(), 0, 0}) + middle;
    const glm::mat4 wall = glm::scale(glm::translate(glm::mat4(1), at), half);
    list.shapes.push_back({ShapeKind::box, wall, k_body});
  }
  OverlapRun::draw(list);
}

}  // namespace

Scene corner_scene() {
  return {
      .name = "corner",
      .summary = "a box in two walls and the floor",
      .methods = all_choices(),
      .default_methods = all_names(),
      .parameters =
          with_settings({{"mass", "kg", "of the box", 1, 1e-9, 1e9},
                         {"depth_x", "", "in the left wall, in sizes", 0.2, 0, 2},
                         {"depth_y", "", "in the floor, in sizes", 0.1, 0, 2},
                         {"depth_z", "", "in the back wall, in sizes", 0.05, 0, 2}},
                        {.iterations = 20, .slop = 0, .gravity = 0}),
      .dt = 1.0 / 60,
      .duration = 0.5,
      .camera = {.target = {0.6F, 0.6F, 0.5F},
                 .distance = 4,
                 .yaw = 0.4F,
                 .pitch = 0.35F},
      .chart_metric = "penetration",
      .start = [](const Setup& setup) { return std::make_unique<Corner>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
