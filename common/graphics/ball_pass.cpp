#include "common/graphics/ball_pass.hpp"

#include <algorithm>

#include "common/graphics/camera.hpp"

namespace timestep {
namespace {

// Below this radius nobody sees that a ball is drawn as a flat point [pixels]
constexpr float k_small = 9;

// Every driver draws points at least this large
constexpr float k_largest_point = 60;

Quads make_balls(ItemForm form) {
  // The shaders read centre and radius as one vector
  static_assert(offsetof(Ball, radius) == offsetof(Ball, center) + 3 * sizeof(float));
  return {sizeof(Ball),
          {{1, 4, offsetof(Ball, center)}, {2, 4, offsetof(Ball, color)}},
          form};
}

}  // namespace

BallPass::BallPass(ResourceManager& resources)
    : square_(resources.load_shader("ball.vert", "ball.frag")),
      square_shadow_(resources.load_shader("ball_shadow.vert", "ball_shadow.frag")),
      point_(resources.load_shader("dot.vert", "dot.frag")),
      point_shadow_(resources.load_shader("dot_shadow.vert", "dot_shadow.frag")),
      squares_(make_balls(ItemForm::square)),
      points_(make_balls(ItemForm::point)) {}

void BallPass::prepare(const DrawList& list, const Frame& frame) {
  large_.clear();
  small_.clear();
  for (const Ball& ball : list.balls) {
    const float pixels =
        ball.radius / (frame.pixel * glm::distance(ball.center, frame.eye));
    const float shadow_pixels = 2 * ball.radius / frame.light.metre;
    const bool small = pixels < k_small && shadow_pixels < k_largest_point;
    (small ? small_ : large_).push_back(ball);
  }
  squares_.upload(std::span<const Ball>(large_));
  points_.upload(std::span<const Ball>(small_));
}

void BallPass::draw_shadows(const Frame& frame) const {
  square_shadow_.set("clip_from_world", frame.light.clip_from_world);
  square_shadow_.set("right", frame.light.right);
  square_shadow_.set("up", frame.light.up);
  squares_.draw(large_.size());

  point_shadow_.set("clip_from_world", frame.light.clip_from_world);
  point_shadow_.set("shadow_metre", frame.light.metre);
  points_.draw(small_.size());
}

void BallPass::draw(const Frame& frame) const {
  // The edge's share of a pixel chooses its samples; the picture stays opaque
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDisable(GL_BLEND);

  set_lighting(square_, frame);
  square_.set("pixel", frame.pixel);
  squares_.draw(large_.size());

  const glm::mat3 view_from_world(Camera(frame.pose).view());
  set_lighting(point_, frame);
  point_.set("pixel", frame.pixel);
  point_.set("light_in_view", view_from_world * frame.light.toward_light);
  point_.set("up_in_view", view_from_world[1]);
  points_.draw(small_.size());

  glEnable(GL_BLEND);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

}  // namespace timestep
