// A body with two equal moments: its axis goes round the angular momentum on a cone.
#include <cmath>
#include <numbers>

#include "chapters/03-rigid-bodies/free_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

class SymmetricTop : public FreeTop {
 public:
  SymmetricTop(const Setup& setup, const glm::dvec3& moments,
               const exact::Turning& start)
      : FreeTop(setup, moments, start),
        momentum_(exact::angular_momentum(start, moments)),
        azimuth_(azimuth(start.q)),
        start_azimuth_(azimuth_) {}

  void observe() override {
    FreeTop::observe();
    azimuth_ += std::remainder(azimuth(now().q) - azimuth_, 2 * std::numbers::pi);
  }

  std::vector<Metric> metrics() const override {
    const double t = time();
    std::vector<Metric> all = FreeTop::metrics();
    all.push_back(
        {"cone_angle", "rad", exact::angle_between(axis(now().q), momentum_)});
    all.push_back(
        {"cone_angle_exact", "rad", exact::angle_between(axis(start().q), momentum_)});
    all.push_back(
        {"precession_rate", "rad/s", t > 0 ? (azimuth_ - start_azimuth_) / t : 0});
    all.push_back(
        {"precession_rate_exact", "rad/s", glm::length(momentum_) / moments().x});
    return all;
  }

 private:
  static glm::dvec3 axis(const glm::dquat& q) { return q * glm::dvec3(0, 0, 1); }

  // How far the axis has gone round the exact L
  double azimuth(const glm::dquat& q) const {
    const glm::dvec3 up =
        glm::length(momentum_) > 0 ? glm::normalize(momentum_) : glm::dvec3(0, 0, 1);
    const glm::dvec3 other =
        std::abs(up.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 e = glm::normalize(glm::cross(up, other));
    return std::atan2(glm::dot(axis(q), glm::cross(up, e)), glm::dot(axis(q), e));
  }

  glm::dvec3 momentum_;
  double azimuth_, start_azimuth_;
};

glm::dvec3 moments_of_top(const Setup& setup) {
  Setup three = setup;
  three.parameters["i2"] = setup.parameters.at("i1");
  return moments_of(three);
}

exact::Turning start_of(const Setup& setup) {
  const auto& p = setup.parameters;
  return {glm::dquat(1, 0, 0, 0), {0, p.at("tumble"), p.at("spin")}};
}

}  // namespace

Scene symmetric_top_scene() {
  return {
      .name = "symmetric-top",
      .summary = "a rod-like body without torque: its axis describes a cone",
      .methods = all_choices(),
      .default_methods = {"listing_3", "momentum", "splitting"},
      .parameters = {{"i1", "kg m²", "both moments across the axis", 1, 1e-12, 1e12},
                     {"i3", "kg m²", "moment about the axis", 0.25, 1e-12, 1e12},
                     {"tumble", "rad/s", "at the start, across the axis", 3, -1e4, 1e4},
                     {"spin", "rad/s", "at the start, about the axis", 10, -1e4, 1e4}},
      .duration = 5,
      .camera = {.target = {0, 0.35F, 0}, .distance = 8.5F, .yaw = 0.6F, .pitch = 0.2F},
      .chart_metric = "momentum_direction_error",
      .start =
          [](const Setup& setup) {
            return std::make_unique<SymmetricTop>(setup, moments_of_top(setup),
                                                  start_of(setup));
          },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
