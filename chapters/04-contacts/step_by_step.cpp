// GJK and EPA, one iteration a step: what happens. step_by_step_picture.cpp shows it.
#include "chapters/04-contacts/step_by_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/graphics/palette.hpp"
#include "common/physics/convex_hull.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

Description description(const Setup& setup, const char* kind) {
  return {static_cast<int>(setup.parameters.at(kind))};
}

Placement placement_of_b(const Setup& setup) {
  const auto& p = setup.parameters;
  const glm::dquat turn = glm::angleAxis(p.at("turn"), glm::dvec3(0, 1, 0));
  const glm::dquat tilt = glm::angleAxis(p.at("tilt"), glm::dvec3(1, 0, 0));
  const glm::dquat roll = glm::angleAxis(p.at("roll"), glm::dvec3(0, 0, 1));
  return {{p.at("x"), p.at("y"), p.at("z")}, roll * turn * tilt};
}

// Points on the core of a shape: all vertices, or many of a smooth one
std::vector<Vec3> points_of(const Specimen& specimen) {
  if (!specimen.vertices.empty()) return specimen.vertices;
  const Convex core = convex(specimen.shape);
  constexpr int k_polar = 12, k_around = 24;
  std::vector<Vec3> points;
  std::uint32_t hint = 0;
  for (int i = 0; i <= k_polar; ++i) {
    for (int j = 0; j < k_around; ++j) {
      const double polar = std::numbers::pi * (i + 0.01) / k_polar;
      const double turn = 2 * std::numbers::pi * (j + 0.37) / k_around;
      const Vec3 d(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                   std::cos(polar));
      const Vec3 p = core.core_support(core.shape, d, hint);
      if (std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
  }
  return points;
}

}  // namespace

StepByStep::StepByStep(const Setup& setup)
    : setup_(setup),
      a_(description(setup, "a")),
      b_(description(setup, "b")),
      pose_b_(pose_of(placement_of_b(setup))),
      difference_(
          minkowski_difference(convex(a_.shape), pose_a_, convex(b_.shape), pose_b_)),
      answer_(separation(a_.shape, pose_a_, b_.shape, pose_b_)) {
  find_hull();
  gjk_ = gjk_start(difference_, nullptr);
  observe();
  for (int i = 0; i < static_cast<int>(setup.parameters.at("from")); ++i) {
    step();
    observe();
  }
}

bool StepByStep::all_flat() const {
  const auto& p = setup_.parameters;
  return std::min(p.at("a"), p.at("b")) >= k_triangle && p.at("turn") == 0
         && p.at("tilt") == 0;
}

// All differences of two points, and their hull; a flat one has none
void StepByStep::find_hull() {
  const std::vector<Vec3> a = points_of(a_), b = points_of(b_);
  std::vector<Vec3> differences;
  for (const Vec3& p : a)
    for (const Vec3& q : b) differences.push_back(difference_at(difference_, p, q));
  hull_ = convex_hull(differences).hull;
  if (hull_.vertices.empty() && differences.size() > 1) {
    // In the plane z = 0, a thin plate shows it
    const std::size_t n = differences.size();
    for (std::size_t i = 0; i < n; ++i)
      differences.push_back(differences[i] + Vec3(0, 0, Real(1e-3)));
    hull_ = convex_hull(differences).hull;
  }
  if (!hull_.vertices.empty()) hull_mesh_ = hull_mesh(hull_);

  // Beside the shapes, so far that neither covers the other
  float low = 0, high = 0;
  for (const Vec3& w : differences) {
    low = std::min(low, static_cast<float>(length(w.x)));
    high = std::max(high, static_cast<float>(length(w.x)));
    const glm::vec3 at = picture(w * difference_.unit);
    if (at.y > top_.y) top_ = at;
  }
  const float b_reach = static_cast<float>(convex(b_.shape).reach) * 0.9F;
  const float edge = std::max(0.6F, picture(pose_b_.position).x + b_reach);
  const float gap = 0.7F;
  const float width = 0.6F + edge + gap + (high - low);
  left_ = {0.6F - width / 2, 0, 0};
  right_ = {width / 2 - high, 0, 0};
}

void StepByStep::step() {
  if (done_) return;
  ++iteration_;
  if (in_epa_) {
    epa_step(difference_, epa_);
    done_ = epa_.done;
  } else if (!gjk_.done) {
    gjk_step(difference_, gjk_);
    done_ = gjk_.done && !meet();
  } else {
    epa_start(difference_, gjk_.simplex, epa_);
    in_epa_ = true;
    done_ = epa_.done;
  }
}

// What the next step looks for, as gjk_step and epa_step do
void StepByStep::observe() {
  if (in_epa_) {
    const int closest = closest_face(epa_.polytope);
    if (closest < 0 || epa_.reason == Reason::flat) {
      lower_ = upper_ = epa_.depth;
      towards_ = epa_.outward;
      return;
    }
    const PolytopeFace& face = epa_.polytope.faces[std::size_t(closest)];
    towards_ = -face.normal;
    next_ = support(difference_, towards_);
    lower_ = face.offset;
    upper_ = std::min(epa_.depth, glm::dot(face.normal, next_.w));
    if (done_) lower_ = upper_ = epa_.depth;
  } else {
    upper_ = glm::length(gjk_.v);
    towards_ = upper_ > 0 ? gjk_.v / upper_ : Vec3(1, 0, 0);
    next_ = support(difference_, towards_);
    lower_ = std::max(gjk_.lower, glm::dot(towards_, next_.w));
    if (done_) lower_ = upper_;
  }
}

std::vector<BodyState> StepByStep::bodies() const {
  return {{.name = "A", .orientation = glm::dquat(1, 0, 0, 0)},
          {.name = "B",
           .position = glm::dvec3(pose_b_.position),
           .orientation = glm::dquat(pose_b_.orientation)}};
}

std::vector<Metric> StepByStep::metrics() const {
  const double bound = in_epa_ ? -length(upper_) : length(upper_);
  const double other = in_epa_ ? -length(lower_) : length(lower_);
  return {{"distance", "m", bound - radii()},
          {"gap", "m", std::abs(bound - other)},
          {"distance_final", "m", double(answer_.distance)},
          {"simplex_points", "", double(gjk_.simplex.size)},
          {"polytope_points", "", double(epa_.polytope.vertex_count)},
          {"polytope_faces", "", double(epa_.polytope.face_count)},
          {"iterations", "", double(iteration_)},
          {"done", "", double(done_)}};
}

Scene step_by_step_scene() {
  const std::string made = "made for this chapter";
  return {
      .name = "step-by-step",
      .summary = "GJK and EPA at work: one iteration a step, with . and back with ,",
      .methods = {{"gjk_epa", "GJK, then EPA where the shapes meet", method_style(0)}},
      .default_methods = {"gjk_epa"},
      .parameters = {{"a", "", k_kind_help, 6, 0, 9, true},
                     {"b", "", k_kind_help, 1, 0, 9, true},
                     {"x", "m", "of B from A, to the right", 0.55, -3, 3},
                     {"y", "m", "upwards", 0.35, -3, 3},
                     {"z", "m", "towards the viewer", 0.15, -3, 3},
                     {"turn", "rad", "of B, about the vertical", 0.5, -7, 7},
                     {"tilt", "rad", "of B, before that, to the viewer", 0.4, -7, 7},
                     {"roll", "rad", "of B, after both, in the picture", 0, -7, 7},
                     {"from", "", "iterations that are done at the start", 0, 0, 300,
                      true}},
      .presets =
          {{"separated", made, {{"a", 6}, {"b", 1}, {"x", 1.5}, {"y", 0.3}}},
           {"touching",
            made,
            {{"a", 1},
             {"b", 1},
             {"x", 1},
             {"y", 0.2},
             {"z", 0},
             {"turn", 0},
             {"tilt", 0}}},
           {"overlapping", made, {{"a", 6}, {"b", 1}, {"x", 0.55}}},
           {"coincident", made, {{"a", 1}, {"b", 1}, {"x", 0}, {"y", 0}, {"z", 0}}},
           {"plane",
            made,
            {{"a", 8},
             {"b", 9},
             {"x", 0.9},
             {"y", 0.8},
             {"z", 0},
             {"turn", 0},
             {"tilt", 0},
             {"roll", 0.4}}},
           {"round", made, {{"a", 4}, {"b", 2}, {"x", 0.8}, {"y", 0.3}, {"z", 0.1}}}},
      .dt = 1,
      .duration = 12,
      .camera = {.target = {0, 0.25F, 0}, .distance = 4.5F, .yaw = 0.3F, .pitch = 0.3F},
      .chart_metric = "gap",
      .chart_logarithmic = true,
      .start = [](const Setup& setup) { return std::make_unique<StepByStep>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
