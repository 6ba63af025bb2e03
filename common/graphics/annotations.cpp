#include "common/graphics/annotations.hpp"

#include <algorithm>
#include <array>

#include "common/graphics/palette.hpp"
#include "common/graphics/pixels.hpp"

namespace timestep {
namespace {

constexpr float k_margin = 22;

struct Rectangle {
  glm::vec2 low{0}, high{0};
};

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y
         && b.low.y < a.high.y;
}

/// Right, left, above or below a point: the first that is free, else to the right.
Rectangle free_place(glm::vec2 point, glm::vec2 size, float gap,
                     const std::vector<Rectangle>& taken) {
  const std::array<glm::vec2, 4> places{
      point + glm::vec2(gap, -size.y - gap / 3),
      point + glm::vec2(-gap - size.x, -size.y - gap / 3),
      point + glm::vec2(-size.x / 2, -size.y - gap),
      point + glm::vec2(-size.x / 2, gap)};
  for (const glm::vec2& low : places) {
    const Rectangle place{low, low + size};
    const auto hits = [&](const Rectangle& other) { return overlap(place, other); };
    if (std::none_of(taken.begin(), taken.end(), hits)) return place;
  }
  return {places[0], places[0] + size};
}

}  // namespace

void add_title(const DrawList& list, Sheet& sheet, const Frame& frame) {
  const float s = frame.scale;
  glm::vec2 pen{k_margin * s, (k_margin + 20) * s};
  if (!list.title.empty()) {
    sheet.text.add(list.title, pen, {24 * s, k_ink, FontFace::bold});
    pen.y += 28 * s;
  }
  for (const std::string& line : list.caption) {
    sheet.text.add(line, pen, {15 * s, k_muted * Color(0.75F, 0.75F, 0.75F, 1)});
    pen.y += 21 * s;
  }
}

void add_sample(const Style& style, glm::vec2 left, float length, Sheet& sheet,
                const Frame& frame) {
  const std::array<glm::vec2, 2> ends{left, left + glm::vec2(length, 0)};
  sheet.lines.add_flat(ends, {style.color, 2.6F * frame.scale, style.dash, false},
                       frame);
  sheet.markers.add_flat(left + glm::vec2(length / 2, 0), style, 12 * frame.scale,
                         frame);
}

void add_legend(const std::vector<LegendEntry>& legend, Sheet& sheet,
                const Frame& frame) {
  if (legend.empty()) return;
  const float s = frame.scale;
  const TextStyle words{15 * s, k_ink};
  const float sample = 44 * s, pad = 12 * s, row = 24 * s;
  float widest = 0;
  for (const LegendEntry& entry : legend) {
    widest = std::max(widest, sheet.text.width(entry.text, words));
  }

  const glm::vec2 size{pad + sample + 10 * s + widest + pad,
                       row * static_cast<float>(legend.size()) + pad};
  const glm::vec2 corner{frame.size.x - k_margin * s - size.x, k_margin * s};
  sheet.panels.add_panel(corner, size, frame);
  glm::vec2 left = corner + glm::vec2(pad, pad / 2 + row / 2);
  for (const LegendEntry& entry : legend) {
    add_sample(entry.style, left, sample, sheet, frame);
    sheet.text.add(entry.text, left + glm::vec2(sample + 10 * s, 5.4F * s), words);
    left.y += row;
  }
}

void add_labels(const std::vector<Label>& labels, Sheet& sheet, const Frame& frame) {
  std::vector<Rectangle> taken;
  for (const Label& label : labels) {
    const glm::vec4 clip = frame.clip_from_world * glm::vec4(label.position, 1);
    if (!is_finite(clip) || clip.w <= 0) continue;
    const TextStyle words{15 * frame.scale, label.color};
    const glm::vec2 size{sheet.text.width(label.text, words), 18 * frame.scale};
    const Rectangle place =
        free_place(pixel_from_clip(frame, clip), size, 9 * frame.scale, taken);
    taken.push_back(place);
    sheet.text.add(label.text, place.low + glm::vec2(0, 14 * frame.scale), words);
  }
}

}  // namespace timestep
