#include "common/graphics/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/graphics/annotations.hpp"
#include "common/graphics/axis.hpp"
#include "common/graphics/palette.hpp"

namespace timestep {
namespace {

constexpr glm::vec2 k_panel{372, 226};
constexpr float k_margin = 22;
constexpr int k_markers = 6;  // on each series

/// One chart on its way to the sheet. Sizes in pixels of a picture 720 pixels high are
/// multiplied by the frame's scale.
class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, glm::vec2 corner, Sheet& sheet, const Frame& frame)
      : chart_(chart), corner_(corner), sheet_(sheet), frame_(frame), s_(frame.scale) {
    std::vector<double> xs, ys;
    for (const ChartSeries& series : chart.series) {
      for (const glm::dvec2& p : series.points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        xs.push_back(p.x);
        ys.push_back(p.y);
      }
    }
    x_ = axis_for(xs, false);
    y_ = axis_for(ys, chart.logarithmic_y);
    if (!xs.empty()) x_.low = *std::min_element(xs.begin(), xs.end());
  }

  void add(const std::vector<LegendEntry>& legend) {
    sheet_.panels.add_panel(corner_, k_panel * s_, frame_);
    const std::vector<Tick> y_ticks = ticks(y_, 4);
    lay_out(y_ticks, legend);
    add_words();
    add_x_axis();
    add_y_axis(y_ticks);
    for (const ChartSeries& series : chart_.series) add_series(series);
  }

 private:
  /// Finds room for the plot between title, names and numbers.
  void lay_out(const std::vector<Tick>& y_ticks,
               const std::vector<LegendEntry>& legend) {
    for (const ChartSeries& series : chart_.series) {
      const auto same = [&](const LegendEntry& e) { return e.text == series.name; };
      if (series.name.empty() || std::any_of(legend.begin(), legend.end(), same))
        continue;
      unnamed_.push_back(&series);
    }
    float widest = 0;
    for (const Tick& tick : y_ticks) {
      widest = std::max(widest, sheet_.text.width(tick.text, small()));
    }
    const float names = unnamed_.empty() ? 0 : 20 * s_;
    low_ = corner_ + glm::vec2(16 * s_ + widest, 40 * s_ + names);
    high_ = corner_ + (k_panel - glm::vec2(18, 40)) * s_;
  }

  void add_words() {
    const glm::vec2 pen = corner_ + glm::vec2(12, 20) * s_;
    sheet_.text.add(chart_.title, pen, {14 * s_, k_ink, FontFace::bold});
    const float y_left =
        pen.x + sheet_.text.width(chart_.title, {14 * s_, k_ink, FontFace::bold})
        + 10 * s_;
    sheet_.text.add(chart_.y_label, {y_left, pen.y}, small());
    const float width = sheet_.text.width(chart_.x_label, small());
    sheet_.text.add(chart_.x_label, {(low_.x + high_.x - width) / 2, high_.y + 32 * s_},
                    small());

    glm::vec2 left = corner_ + glm::vec2(14, 36) * s_;
    for (const ChartSeries* series : unnamed_) {
      add_sample(series->style, left, 26 * s_, sheet_, frame_);
      left.x += 32 * s_;
      sheet_.text.add(series->name, left + glm::vec2(0, 4 * s_), small());
      left.x += sheet_.text.width(series->name, small()) + 14 * s_;
    }
  }

  void add_x_axis() {
    add_rule({low_.x, high_.y}, high_, k_muted);
    for (const Tick& tick : ticks(x_, 5)) {
      const float x =
          glm::mix(low_.x, high_.x, static_cast<float>(x_.share(tick.value)));
      if (x < low_.x - 1) continue;
      add_rule({x, high_.y}, {x, high_.y + 4 * s_}, k_muted);
      const float width = sheet_.text.width(tick.text, small());
      sheet_.text.add(tick.text, {x - width / 2, high_.y + 17 * s_}, small());
    }
  }

  void add_y_axis(const std::vector<Tick>& y_ticks) {
    for (const Tick& tick : y_ticks) {
      const float y =
          glm::mix(high_.y, low_.y, static_cast<float>(y_.share(tick.value)));
      add_rule({low_.x, y}, {high_.x, y}, {k_muted.r, k_muted.g, k_muted.b, 0.25F});
      const float width = sheet_.text.width(tick.text, small());
      sheet_.text.add(tick.text, {low_.x - 6 * s_ - width, y + 4 * s_}, small());
    }
  }

  void add_rule(glm::vec2 from, glm::vec2 to, Color color) {
    const glm::vec2 half{0.5F};
    const std::array<glm::vec2, 2> ends{glm::floor(from) + half, glm::floor(to) + half};
    sheet_.lines.add_flat(ends, {color, std::max(1.0F, s_), Dash::solid, false},
                          frame_);
  }

  /// Where a point goes; not finite if it has no place.
  glm::vec2 pixel(glm::dvec2 p) const {
    const bool placeless = !std::isfinite(p.x) || !std::isfinite(p.y)
                           || (chart_.logarithmic_y && p.y <= 0);
    if (placeless) return glm::vec2(std::numeric_limits<float>::quiet_NaN());
    const glm::vec2 share{x_.share(p.x), std::max(y_.share(p.y), -0.02)};
    return glm::mix(glm::vec2(low_.x, high_.y), glm::vec2(high_.x, low_.y), share);
  }

  void add_series(const ChartSeries& series) {
    // More points than pixels tell nothing new; those without a place break the line
    std::vector<glm::vec2> line;
    for (const glm::dvec2& p : series.points) {
      const glm::vec2 place = pixel(p);
      const bool near = !line.empty() && glm::distance(line.back(), place) < 0.7F;
      if (!near) line.push_back(place);
    }
    sheet_.lines.add_flat(line, {series.style.color, 2 * s_, series.style.dash, false},
                          frame_);
    add_markers(series, line);
  }

  /// A few markers, evenly along x, and one at the end.
  void add_markers(const ChartSeries& series, const std::vector<glm::vec2>& line) {
    const float spacing = (high_.x - low_.x) / k_markers;
    float next = low_.x;
    const glm::vec2* last = nullptr;
    for (const glm::vec2& p : line) {
      if (!std::isfinite(p.y)) continue;
      last = &p;
      if (p.x < next) continue;
      sheet_.markers.add_flat(p, series.style, 9 * s_, frame_);
      next = p.x + spacing;
    }
    if (last != nullptr) sheet_.markers.add_flat(*last, series.style, 9 * s_, frame_);
  }

  TextStyle small() const { return {12 * s_, k_muted * Color(0.7F, 0.7F, 0.7F, 1)}; }

  const Chart& chart_;
  glm::vec2 corner_;
  Sheet& sheet_;
  const Frame& frame_;
  float s_;
  Axis x_, y_;
  glm::vec2 low_{0}, high_{0};  ///< the plot's corners, top left and lower right
  std::vector<const ChartSeries*> unnamed_;
};

}  // namespace

void add_charts(const DrawList& list, Sheet& sheet, const Frame& frame) {
  const glm::vec2 step{0, (k_panel.y + 12) * frame.scale};
  glm::vec2 corner = frame.size - (k_panel + k_margin) * frame.scale;
  if (list.chart_side == Side::left) corner.x = k_margin * frame.scale;
  for (auto chart = list.charts.rbegin(); chart != list.charts.rend(); ++chart) {
    ChartDrawing(*chart, corner, sheet, frame).add(list.legend);
    corner -= step;
  }
}

}  // namespace timestep
