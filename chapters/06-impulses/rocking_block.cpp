// A tall block that is tilted and let go: it rocks from corner to corner, and every
// impact takes a share of its energy that its shape alone decides.
#include <algorithm>
#include <cmath>
#include <memory>

#include "chapters/06-impulses/body_picture.hpp"
#include "chapters/06-impulses/world_run.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/palette.hpp"
#include "common/physics/exact_tipping.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class Rocking : public WorldRun {
 public:
  explicit Rocking(const Setup& setup);
  void draw_reference(DrawList& list) const override;

 private:
  void after_step() override;
  std::vector<Metric> own_metrics() const override;
  exact::RockingBlock block() const;
  double tilt() const;
  double rate() const;
  double exact_tilt(int impacts) const;
  double exact_time(int impacts) const;

  BodyHandle handle_{};
  int impacts_ = 0;
  double tilt_before_ = 0, rate_before_ = 0, time_before_ = 0;  // of the step before
  double impact_time_ = 0, first_impact_ = 0, peak_ = 0, first_peak_ = 0, ratio_ = 0;
};

// The block is 1 m high in the picture
Rocking::Rocking(const Setup& setup)
    : WorldRun(setup, {.scale = 1 / float(setup.parameters.at("height")),
                       .force = 0.3F / float(setup.parameters.at("gravity")),
                       .contacts_as_dots = true}) {
  const double mu = parameter("friction"), tilt = parameter("tilt");
  if (tilt >= exact::block_angle(block()))
    throw InputError("--set tilt=…: the block topples");
  const double height = parameter("height"), width = parameter("width");
  const glm::dvec3 size(width, height, height / 2);
  add("floor", RigidBody{}, floor_collider(mu, 0), k_body);

  // About its right corner, which stays where it is
  const double s = std::sin(tilt), c = std::cos(tilt);
  const glm::dvec3 middle(-width / 2 * c + height / 2 * s,
                          width / 2 * s + height / 2 * c, 0);
  RigidBody body = box_body(1, size, middle + glm::dvec3(width / 2, 0, 0));
  body.orientation = Quat(glm::angleAxis(-tilt, glm::dvec3(0, 0, 1)));
  handle_ = add("block", body, box_collider(size, mu, 0), body_color(0));
  tilt_before_ = first_peak_ = tilt;
}

exact::RockingBlock Rocking::block() const {
  return {parameter("width") / 2, parameter("height") / 2, parameter("gravity")};
}

// About z, clockwise [rad] and [rad/s]
double Rocking::tilt() const {
  const glm::dvec3 up =
      glm::dquat(body_of(world(), handle_).orientation) * glm::dvec3(0, 1, 0);
  return std::atan2(up.x, up.y);
}
double Rocking::rate() const {
  return -double(body_of(world(), handle_).angular_velocity.z);
}

// How far it tilts after so many impacts, and when the last of them is
double Rocking::exact_tilt(int impacts) const {
  double tilt = parameter("tilt");
  for (int i = 0; i < impacts; ++i) tilt = exact::next_tilt(block(), tilt);
  return tilt;
}
double Rocking::exact_time(int impacts) const {
  double time = 0, tilt = parameter("tilt");
  for (int i = 0; i < impacts; ++i) {
    time += (i == 0 ? 1 : 2) * exact::quarter_time(block(), tilt);
    tilt = exact::next_tilt(block(), tilt);
  }
  return time;
}

void Rocking::after_step() {
  const double now = tilt();
  if (steps() == 0 || now == 0) return;

  // It passes upright in between, at one rate before and another after
  if (now * tilt_before_ < 0) {
    const double share = tilt_before_ / (tilt_before_ - now);
    impact_time_ = time_before_ + share * (time() - time_before_);
    if (impacts_ == 0) first_impact_ = impact_time_;
    if (impacts_ == 0) ratio_ = rate() / rate_before_;
    ++impacts_;
    peak_ = 0;
  }
  peak_ = std::max(peak_, std::abs(now));
  if (impacts_ == 1) first_peak_ = peak_;
  tilt_before_ = now;
  rate_before_ = rate();
  time_before_ = time();
}

std::vector<Metric> Rocking::own_metrics() const {
  const double exact_ratio = exact::rate_ratio(block());
  const double first = impacts_ == 0 ? 0 : first_peak_;
  return {
      {"impacts", "", static_cast<double>(impacts_)},
      {"first_impact", "s", first_impact_},
      {"first_impact_exact", "s", exact::quarter_time(block(), parameter("tilt"))},
      {"last_impact", "s", impact_time_},
      {"last_impact_exact", "s", exact_time(impacts_)},
      {"rate_ratio", "", ratio_},
      {"rate_ratio_exact", "", exact_ratio},
      {"next_tilt", "rad", first},
      {"next_tilt_exact", "rad", exact_tilt(1)},
      {"energy_kept_exact", "", exact_ratio * exact_ratio},
      {"tilt", "rad", tilt()},
  };
}

// How far it should tilt by now, to either side: along its front
void Rocking::draw_reference(DrawList& list) const {
  const double alpha = exact::block_angle(block()), most = exact_tilt(impacts_);
  const double diagonal = std::hypot(parameter("width"), parameter("height"));
  for (const int side : {-1, 1}) {
    const double angle = most - alpha;
    const glm::dvec3 corner(side * parameter("width") / 2, 0, parameter("height") / 4);
    const glm::dvec3 to =
        corner + diagonal * glm::dvec3(side * std::sin(angle), std::cos(angle), 0);
    list.lines.push_back({.points = {picture(corner), picture(to)},
                          .color = k_ink,
                          .width = 2,
                          .dash = Dash::dashed});
  }
  list.legend.push_back({reference_style(), "exact: diagonal at the next turn"});
}

}  // namespace

Scene rocking_block_scene() {
  return {
      .name = "rocking-block",
      .summary = "a tilted block rocks from corner to corner, less and less",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = with_settings(
          {{"width", "m", "of the block", 0.2, 1e-6, 1e6},
           {"height", "m", "of the block", 0.8, 1e-6, 1e6},
           {"tilt", "rad", "at the start; the block rests at 0", 0.15, 1e-6, 1.5},
           {"friction", "", "of block and floor", 0.8, 0, 100}}),
      .dt = 1.0 / 240,
      .duration = 3,
      .camera = {.target = {0.05F, 0.55F, 0},
                 .distance = 2.1F,
                 .yaw = 0.2F,
                 .pitch = 0.12F},
      .chart_metric = "tilt",
      .start = [](const Setup& setup) { return std::make_unique<Rocking>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
