// A plank with one end in the ground. No gravity.
#include <cmath>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "chapters/05-penetration/least_motion.hpp"
#include "chapters/05-penetration/parts.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_05 {
namespace {

// Half of it along x, y and z, in sizes
constexpr glm::dvec3 k_half{0.5, 0.03, 0.15};

// Its left end is the lower one
glm::dquat tilted(double tilt) {
  return glm::angleAxis(tilt, glm::dvec3(0, 0, 1));
}

class TiltedPlank : public OverlapRun {
 public:
  explicit TiltedPlank(const Setup& setup);

 private:
  void add_metrics(std::vector<Metric>& metrics) const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override { list.ground_height.reset(); }

  PlankPlace start_{}, right_{};
};

TiltedPlank::TiltedPlank(const Setup& setup)
    : OverlapRun(setup,
                 {.apart = {1.3F, 0.75F}, .columns = 2, .mark = {-0.62F, 0, 0}}) {
  add_wall({0, 1, 0}, 0);
  const Shape shape = Box{Vec3(size() * k_half)};
  const double mass = parameter("mass");
  const double inertia = 1 / double(solid(mass, shape, {}).inverse_inertia.z);
  const Plank plank{2 * size() * k_half.x, 2 * size() * k_half.y, mass, inertia};

  // As high as its lower edge is deep
  start_.tilt = parameter("tilt");
  start_.height = plank_depth(plank, start_) - size() * parameter("depth");
  right_ = plank_out(plank, start_);
  const Place start{.position = {0, start_.height, 0},
                    .orientation = tilted(start_.tilt)};
  add_body("plank", solid(mass, shape, start), shape,
           {{0, right_.height, 0}, tilted(right_.tilt)});
}

void TiltedPlank::add_metrics(std::vector<Metric>& metrics) const {
  const Vec3 along = body(0).orientation * Vec3(1, 0, 0);
  const double tilt = std::atan2(double(along.y), double(along.x));
  metrics.push_back({"lift", "m", double(body(0).position.y) - start_.height});
  metrics.push_back({"lift_exact", "m", right_.height - start_.height});
  metrics.push_back({"turn", "rad", start_.tilt - tilt});
  metrics.push_back({"turn_exact", "rad", start_.tilt - right_.tilt});
}

// A piece of the ground, so thin that one sees what is below
void TiltedPlank::draw(DrawList& list) const {
  const glm::mat4 ground = glm::translate(glm::mat4(1), picture({origin(), 0, 0}));
  list.shapes.push_back(
      {ShapeKind::box, glm::scale(ground, glm::vec3(0.55F, 0.004F, 0.2F)), k_body});
  OverlapRun::draw(list);
}

}  // namespace

Scene tilted_plank_scene() {
  return {
      .name = "tilted-plank",
      .summary = "a plank with one end in the ground: up, or level?",
      .methods = all_choices(),
      .default_methods = all_names(),
      .parameters = with_settings(
          {{"mass", "kg", "of the plank", 5, 1e-9, 1e9},
           {"tilt", "rad", "how steep it stands", 0.4, 0, 1.5},
           {"depth", "", "of the lower edge in the ground, in sizes", 0.1, 0, 1}},
          {.iterations = 20, .slop = 0, .gravity = 0}),
      .dt = 1.0 / 60,
      .duration = 0.5,
      .camera = {.target = {0, 0.25F, 0}, .distance = 2, .yaw = 0.1F, .pitch = 0.1F},
      .chart_metric = "penetration",
      .start = [](const Setup& setup) { return std::make_unique<TiltedPlank>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_05
