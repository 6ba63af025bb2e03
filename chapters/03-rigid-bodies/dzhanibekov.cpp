// A spin about the middle axis: it turns over, and back, again and again.
#include <cmath>

#include "chapters/03-rigid-bodies/free_top.hpp"
#include "common/physics/exact_free_top.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {
namespace {

// Counts changes of sign and measures the time between them
class Crossings {
 public:
  void add(double t, double value) {
    if (value_ * value < 0) {
      const double at = t_ + (t - t_) * value_ / (value_ - value);
      if (count_ == 0) first_ = at;
      last_ = at;
      ++count_;
    }
    if (value != 0) value_ = value;
    t_ = t;
  }
  int count() const { return count_; }
  double mean_interval() const {
    return count_ > 1 ? (last_ - first_) / (count_ - 1) : 0;
  }

 private:
  double t_ = 0, value_ = 0, first_ = 0, last_ = 0;
  int count_ = 0;
};

class Dzhanibekov : public FreeTop {
 public:
  using FreeTop::FreeTop;

  void observe() override {
    FreeTop::observe();
    flips_.add(time(), now().omega.y);
    exact_flips_.add(time(), exact_now().omega.y);
  }

  std::vector<Metric> metrics() const override {
    const double interval = exact::flip_interval(moments(), start().omega);
    std::vector<Metric> all{
        {"flips", "", static_cast<double>(flips_.count())},
        {"flips_exact", "", static_cast<double>(exact_flips_.count())},
        {"flip_interval", "s", flips_.mean_interval()},
        {"flip_interval_exact", "s", std::isfinite(interval) ? interval : 0}};
    const std::vector<Metric> more = FreeTop::metrics();
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

 private:
  Crossings flips_, exact_flips_;
};

exact::Turning start_of(const Setup& setup) {
  const double spin = setup.parameters.at("spin");
  const double side = setup.parameters.at("perturbation");
  return {glm::dquat(1, 0, 0, 0), {side, spin, side}};
}

}  // namespace

Scene dzhanibekov_scene() {
  return {
      .name = "dzhanibekov",
      .summary = "a spin about the middle axis turns over: count the flips",
      .methods = all_choices(),
      .default_methods = {"listing_3", "explicit_rescaled_L", "implicit_gyroscopic",
                          "splitting"},
      .parameters = {{"i1", "kg m²", "first principal moment", 1, 1e-12, 1e12},
                     {"i2", "kg m²", "second principal moment", 2, 1e-12, 1e12},
                     {"i3", "kg m²", "third principal moment", 2.5, 1e-12, 1e12},
                     {"spin", "rad/s", "at the start, about axis 2", 10, -1e4, 1e4},
                     {"perturbation", "rad/s", "at the start, about axes 1 and 3", 0.1,
                      -1e4, 1e4}},
      .duration = 60,
      .camera = {.target = {0, 0.35F, 0}, .distance = 8.5F, .yaw = 0, .pitch = 0.15F},
      .chart_metric = "flips",
      .start =
          [](const Setup& setup) {
            return std::make_unique<Dzhanibekov>(setup, moments_of(setup),
                                                 start_of(setup));
          },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
