// One body past or through another: what every method says of it, and its jumps.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chapters/04-contacts/judgement.hpp"
#include "chapters/04-contacts/parts.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

using double_precision::chapter_04::KnownSeparation;
using double_precision::chapter_04::Reference;

class Sweep : public Simulation {
 public:
  explicit Sweep(const Setup& setup);

  void step() override;
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return evaluations_; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;

 private:
  double parameter(const char* name) const { return setup_.parameters.at(name); }
  Placement place_of_a() const;
  Placement place_of_b(long long step) const;
  Separation ask() const;
  double size() const { return std::max(a_.like.size, b_.like.size); }
  PosedPair pair() const;
  double farthest() const;
  void look_for_jumps();
  glm::vec3 in_picture(const glm::dvec3& p) const;

  struct Body {
    Description like;
    Specimen specimen;
  };

  Setup setup_;
  PairMethod method_;
  Body a_, b_;
  Reference reference_;
  Separation answer_{}, previous_{};
  KnownSeparation known_{};
  long long steps_ = 0, evaluations_ = 0;

  Judgement worst_;
  double normal_jump_ = 0, normal_jump_known_ = 0, distance_jump_ = 0;
};

Description like(const Setup& setup, const char* kind, bool is_b) {
  const auto& p = setup.parameters;
  const double size = p.at("size") * (is_b ? p.at("ratio") : 1);
  return {static_cast<int>(p.at(kind)), size, p.at("stretch")};
}

Sweep::Sweep(const Setup& setup)
    : setup_(setup),
      method_(method_named(setup.method)),
      a_{like(setup, "a", false), Specimen(like(setup, "a", false))},
      b_{like(setup, "b", true), Specimen(like(setup, "b", true))},
      reference_(a_.like, b_.like) {
  answer_ = ask();
}

Placement Sweep::place_of_a() const {
  return {glm::dvec3(parameter("origin"), 0, 0)};
}

// Along x, at even steps; lengths in widths of A
Placement Sweep::place_of_b(long long step) const {
  const double share = static_cast<double>(step) * setup_.dt / setup_.duration;
  const double x =
      parameter("from") + (parameter("to") - parameter("from")) * std::min(share, 1.0);
  const glm::dvec3 at = 2 * a_.like.size * glm::dvec3(x, parameter("offset"), 0);
  const glm::dquat turn = glm::angleAxis(parameter("turn"), glm::dvec3(0, 1, 0));
  const glm::dquat tilt = glm::angleAxis(parameter("tilt"), glm::dvec3(1, 0, 0));
  return {place_of_a().position + at, turn * tilt};
}

Separation Sweep::ask() const {
  const PosedPair p = pair();
  return method_.query(p.a, p.pose_a, p.b, p.pose_b);
}

void Sweep::step() {
  const auto name = [](const Body& body) {
    return k_kind_names[static_cast<std::size_t>(body.like.kind)];
  };
  const bool takes = method_.takes(a_.specimen.shape, b_.specimen.shape);
  if (!takes || answer_.reason == Reason::out_of_range)
    throw StepFailure(fmt::format("no solution for {} and {}: {}", name(a_), name(b_),
                                  takes ? "numbers out of range" : "not its pair"));
  ++steps_;
  answer_ = ask();
  evaluations_ += answer_.iterations;
}

PosedPair Sweep::pair() const {
  return {a_.specimen.shape, pose_of(place_of_a()), b_.specimen.shape,
          pose_of(place_of_b(steps_))};
}

// No distance, or less than it
bool is_unsure(const Separation& s) {
  return s.reason == Reason::lower_bound || s.reason == Reason::no_answer;
}

// A signed distance cannot change by more than B moved
void Sweep::look_for_jumps() {
  if (is_unsure(answer_) || is_unsure(previous_)) return;
  const double moved =
      glm::distance(place_of_b(steps_).position, place_of_b(steps_ - 1).position);
  const double change = std::abs(static_cast<double>(answer_.distance)
                                 - static_cast<double>(previous_.distance));
  distance_jump_ = std::max(distance_jump_, change - moved);
  normal_jump_ = std::max(
      normal_jump_,
      exact::angle_between(glm::dvec3(answer_.normal), glm::dvec3(previous_.normal)));
}

// The largest coordinate, whose rounding moves surfaces [m]
double Sweep::farthest() const {
  const glm::dvec3 b = place_of_b(steps_).position;
  return size() * std::max(1.0, parameter("stretch")) + glm::length(b);
}

void Sweep::observe() {
  const KnownSeparation before = known_;
  known_ = reference_.at(place_of_a(), place_of_b(steps_));
  judge(worst_, answer_, pair(), known_, farthest());
  if (steps_ > 0) {
    look_for_jumps();
    const double turned = exact::angle_between(before.normal, known_.normal);
    normal_jump_known_ = std::max(normal_jump_known_, turned);
  }
  previous_ = answer_;
}

std::vector<BodyState> Sweep::bodies() const {
  const auto state = [](const char* name, const Placement& p) {
    return BodyState{
        .name = name, .position = p.position, .orientation = p.orientation};
  };
  return {state("A", place_of_a()), state("B", place_of_b(steps_))};
}

std::vector<Metric> Sweep::metrics() const {
  const double worst = std::max(worst_.distance_error, worst_.depth_error);
  std::vector<Metric> metrics{{"distance", "m", static_cast<double>(answer_.distance)},
                              {"distance_known", "m", known_.distance},
                              {"relative_error_max", "", worst / size()},
                              {"normal_jump_max", "rad", normal_jump_},
                              {"normal_jump_known", "rad", normal_jump_known_},
                              {"distance_jump_max", "m", distance_jump_}};
  add_metrics(metrics, worst_);
  return metrics;
}

// About A; the larger body is 1 m wide in the picture, however large it is
glm::vec3 Sweep::in_picture(const glm::dvec3& p) const {
  return glm::vec3((p - place_of_a().position) / (2 * size()));
}

void Sweep::draw(DrawList& list) const {
  if (is_unsure(answer_)) return;
  const glm::vec3 a = in_picture(glm::dvec3(answer_.on_a));
  const glm::vec3 b = in_picture(glm::dvec3(answer_.on_b));
  const Color& color = setup_.style.color;
  list.lines.push_back({.points = {a, b}, .color = color, .width = 3});
  list.arrows.push_back({.from = a,
                         .to = a + 0.5F * picture(answer_.normal),
                         .color = color,
                         .width = 4});
  list.markers.push_back({a, setup_.style, 12});
  list.markers.push_back({b, setup_.style, 8});
}

void Sweep::draw_reference(DrawList& list) const {
  const float scale = static_cast<float>(1 / (2 * size()));
  const auto show = [&](const Body& body, const Placement& p, const Color& color) {
    const glm::mat4 place = placed(in_picture(p.position), p.orientation, scale);
    draw_specimen(list, body.specimen, place, color);
  };
  const Placement b = place_of_b(steps_), end = place_of_b(1LL << 40);
  show(a_, place_of_a(), with_alpha(k_color_a, 0.6F));
  show(b_, b, with_alpha(k_color_b, 0.45F));
  list.lines.push_back(
      {.points = {in_picture(place_of_b(0).position), in_picture(end.position)},
       .color = k_muted,
       .width = 1.5F,
       .dash = Dash::dotted});

  // The normal that is known, from B's centre
  const glm::vec3 from = in_picture(b.position);
  list.arrows.push_back({.from = from,
                         .to = from + 0.4F * glm::vec3(known_.normal),
                         .color = k_ink,
                         .width = 2});
  list.legend.push_back({reference_style(), "best known normal"});
  list.ground_height.reset();
}

}  // namespace

Scene sweep_scene() {
  return {
      .name = "sweep",
      .summary = "a body past or through another: depth and normal by every method",
      .methods = all_choices(),
      .default_methods = {"gjk_epa", "sat", "libccd_epa", "libccd_mpr"},
      .parameters = {{"a", "", k_kind_help, 1, 0, 9, true},
                     {"b", "", k_kind_help, 1, 0, 9, true},
                     {"size", "m", "half the width of A", 0.5, 1e-310, 1e300},
                     {"ratio", "", "width of B, in widths of A", 1, 1e-9, 1e9},
                     {"stretch", "", "of both along their own z axes", 1, 1e-9, 1e9},
                     {"from", "", "start of B beside A, in widths of A", -1.6, -1e9,
                      1e9},
                     {"to", "", "end of that", 1.6, -1e9, 1e9},
                     {"offset", "", "of the path, above A's centre, likewise", 0.3,
                      -1e9, 1e9},
                     {"turn", "rad", "of B, about the vertical", 0.5, -7, 7},
                     {"tilt", "rad", "of B, before that, about the path", 0.4, -7, 7},
                     {"origin", "m", "of the world from A", 0, -1e300, 1e300}},
      .presets = {{"spheres", "made for this chapter", {{"a", 0}, {"b", 0}}},
                  {"sphere-box", "made for this chapter", {{"a", 1}, {"b", 0}}},
                  {"cylinder-cone", "made for this chapter", {{"a", 4}, {"b", 5}}},
                  {"hulls", "made for this chapter", {{"a", 7}, {"b", 7}}},
                  {"aligned",
                   "made for this chapter",
                   {{"a", 1}, {"b", 1}, {"turn", 0}, {"tilt", 0}, {"offset", 0.3}}}},
      .dt = 1.0 / 60,
      .duration = 4,
      .camera = {.target = {0, 0.1F, 0}, .distance = 4.2F, .yaw = 0.25F, .pitch = 0.2F},
      .chart_metric = "distance",
      .start = [](const Setup& setup) { return std::make_unique<Sweep>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
