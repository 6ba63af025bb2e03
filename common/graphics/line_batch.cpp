#include "common/graphics/line_batch.hpp"

#include <algorithm>
#include <cmath>

#include "common/graphics/pixels.hpp"

namespace timestep {
namespace {

/// Length drawn and length left out, in widths; the ends are round, which adds a width.
glm::vec2 dash_form(Dash dash, float width) {
  switch (dash) {
    case Dash::solid:
      return {0, 0};
    case Dash::dashed:
      return {width * 2.6F, width * 2.6F + 2};
    case Dash::dotted:
      return {0, width * 1.9F + 1};
  }
  return {0, 0};
}

/// Where between two points in clip space the line crosses the plane in front of the
/// eye.
float crossing(const glm::vec4& a, const glm::vec4& b) {
  const float in_a = a.z + a.w, in_b = b.z + b.w;
  return in_a / (in_a - in_b);
}

bool in_front(const glm::vec4& clip) {
  return clip.z + clip.w > 0 && clip.w > 0;
}

}  // namespace

LineBatch::LineBatch(ResourceManager& resources)
    : shader_(resources.load_shader("line.vert", "line.frag")),
      quads_(sizeof(Point), {{1, 4, offsetof(Point, clip)},
                             {2, 4, sizeof(Point) + offsetof(Point, clip)},
                             {3, 4, 2 * sizeof(Point) + offsetof(Point, clip)},
                             {4, 4, 3 * sizeof(Point) + offsetof(Point, clip)},
                             {5, 4, sizeof(Point) + offsetof(Point, color)},
                             {6, 4, 2 * sizeof(Point) + offsetof(Point, color)},
                             {7, 4, sizeof(Point) + offsetof(Point, half_width)},
                             {8, 4, 2 * sizeof(Point) + offsetof(Point, half_width)}}) {
}

void LineBatch::add(std::span<const glm::vec3> world, const Stroke& stroke,
                    const Frame& frame) {
  std::vector<glm::vec4> clip;
  clip.reserve(world.size());
  for (const glm::vec3& p : world) clip.push_back(toward_eye(frame, p, 0.005F));
  add_clip(clip, stroke, frame);
}

void LineBatch::add_flat(std::span<const glm::vec2> pixels, const Stroke& stroke,
                         const Frame& frame) {
  std::vector<glm::vec4> clip;
  clip.reserve(pixels.size());
  for (const glm::vec2& p : pixels) clip.push_back(clip_from_pixel(frame, p));
  add_clip(clip, stroke, frame);
}

void LineBatch::add_clip(std::span<const glm::vec4> clip, const Stroke& stroke,
                         const Frame& frame) {
  // Cut off what is behind the eye; each run in front of it is a line of its own
  std::vector<glm::vec4> run;
  std::vector<float> alphas;
  const auto finish = [&] {
    add_run(run, alphas, stroke, frame);
    run.clear();
    alphas.clear();
  };
  const auto last = static_cast<float>(std::max<std::size_t>(clip.size(), 2) - 1);
  for (std::size_t i = 0; i < clip.size(); ++i) {
    const glm::vec4& p = clip[i];
    const bool usable = is_finite(p);
    const float alpha = stroke.fade ? static_cast<float>(i) / last : 1;
    const bool joined = i > 0 && usable && is_finite(clip[i - 1]);
    if (!usable || !joined) finish();
    if (joined && in_front(p) != in_front(clip[i - 1])) {
      run.push_back(glm::mix(clip[i - 1], p, crossing(clip[i - 1], p)));
      alphas.push_back(alpha);
      if (!in_front(p)) finish();
    }
    if (usable && in_front(p)) {
      run.push_back(p);
      alphas.push_back(alpha);
    }
  }
  finish();
}

void LineBatch::add_run(std::span<const glm::vec4> clip, std::span<const float> alphas,
                        const Stroke& stroke, const Frame& frame) {
  if (clip.size() < 2) return;
  const glm::vec2 dash = dash_form(stroke.dash, stroke.width);
  float length = 0;
  for (std::size_t i = 0; i < clip.size(); ++i) {
    if (i > 0) {
      length += glm::distance(pixel_from_clip(frame, clip[i - 1]),
                              pixel_from_clip(frame, clip[i]));
    }
    Color color = stroke.color;
    color.a *= alphas[i];
    const Point point{clip[i], color, stroke.width / 2, length, dash.x, dash.y};
    if (i == 0) add_break(point);
    points_.push_back(point);
  }
  add_break(points_.back());
}

void LineBatch::add_arrow(const Arrow& arrow, const Frame& frame) {
  const glm::vec4 from = toward_eye(frame, arrow.from, 0.005F);
  const glm::vec4 to = toward_eye(frame, arrow.to, 0.005F);
  if (!is_finite(from) || !is_finite(to) || !in_front(from) || !in_front(to)) return;
  const float length =
      glm::distance(pixel_from_clip(frame, from), pixel_from_clip(frame, to));
  if (length < 1) return;

  // A short arrow is all head, and smaller; it still points the right way
  const float width = arrow.width * frame.scale;
  const float head = std::min(4.2F * width, 0.7F * length);
  const float head_width = head * 0.8F;
  const float share = 1 - head / length;

  // The neck in clip space such that it lies at that share on the picture
  const float t = share * from.w / (share * from.w + (1 - share) * to.w);
  const glm::vec4 neck = glm::mix(from, to, t);
  add_tapered(from, neck, std::min(width, head_width / 2),
              std::min(width, head_width / 2), arrow.color);
  add_tapered(neck, to, head_width, 0, arrow.color);
}

void LineBatch::add_tapered(glm::vec4 from, glm::vec4 to, float from_width,
                            float to_width, const Color& color) {
  const Point start{from, color, from_width / 2, 0, 0, 0};
  const Point end{to, color, to_width / 2, 0, 0, 0};
  add_break(start);
  points_.push_back(start);
  points_.push_back(end);
  add_break(end);
}

void LineBatch::add_break(const Point& beside) {
  points_.push_back(beside);
  points_.back().half_width = -1;
}

void LineBatch::draw(const Frame& frame) {
  if (points_.size() < 4) return;
  quads_.upload(std::span<const Point>(points_));
  shader_.set("half_size", frame.size / 2.0F);
  quads_.draw(points_.size() - 3);
}

}  // namespace timestep
