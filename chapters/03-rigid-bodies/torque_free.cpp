// An asymmetric body without torque: everything that a rotation method can get wrong.
#include "chapters/03-rigid-bodies/free_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

exact::Turning start_of(const Setup& setup) {
  const auto& p = setup.parameters;
  return {glm::dquat(1, 0, 0, 0), {p.at("omega1"), p.at("omega2"), p.at("omega3")}};
}

}  // namespace

Scene torque_free_scene() {
  return {
      .name = "torque-free",
      .summary = "an asymmetric body without torque, beside its elliptic functions",
      .methods = all_choices(),
      .default_methods = {"listing_3", "implicit_gyroscopic", "splitting", "rk4"},
      .parameters = {{"i1", "kg m²", "first principal moment", 1, 1e-12, 1e12},
                     {"i2", "kg m²", "second principal moment", 2, 1e-12, 1e12},
                     {"i3", "kg m²", "third principal moment", 2.5, 1e-12, 1e12},
                     {"omega1", "rad/s", "at the start, about axis 1", 0.4, -1e4, 1e4},
                     {"omega2", "rad/s", "at the start, about axis 2", 1, -1e4, 1e4},
                     {"omega3", "rad/s", "at the start, about axis 3", 0.8, -1e4, 1e4}},
      .duration = 10,
      .camera = {.target = {0, 0.35F, 0}, .distance = 8.5F, .yaw = 0, .pitch = 0.15F},
      .chart_metric = "attitude_error",
      .chart_logarithmic = true,
      .start =
          [](const Setup& setup) {
            return std::make_unique<FreeTop>(setup, moments_of(setup), start_of(setup));
          },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
