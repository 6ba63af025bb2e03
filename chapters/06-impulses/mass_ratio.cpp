// A heavy box on a light one: what holds the upper one must come through the lower.
#include <memory>

#include "chapters/06-impulses/standing.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {
namespace {

class MassRatio : public Standing {
 public:
  explicit MassRatio(const Setup& setup);

 private:
  std::vector<Metric> own_metrics() const override;
  double impulse_error() const;
};

MassRatio::MassRatio(const Setup& setup) : Standing(setup) {
  add_box({0, 0.5, 0});
  add_box({0, 1.5, 0}, glm::dvec3(1), parameter("ratio"));
}

// What holds the light box's lower side, over what it should be, less 1
double MassRatio::impulse_error() const {
  double weight = 0, sum = 0;
  for (const RigidBody& body : world().bodies)
    if (body.inverse_mass > 0) weight += mass_of(body) * parameter("gravity");
  for (const PointContact& contact : world().contacts)
    if (world().bodies[contact.a].inverse_mass == 0) sum += double(contact.impulse.y);
  return weight > 0 ? sum / (weight * impulse_time()) - 1 : 0;
}

std::vector<Metric> MassRatio::own_metrics() const {
  std::vector<Metric> all = Standing::own_metrics();
  all.push_back({"impulse_error", "", impulse_error()});
  return all;
}

}  // namespace

Scene mass_ratio_scene() {
  return {
      .name = "mass-ratio",
      .summary = "a heavy box on a light one",
      .methods = all_choices(),
      .default_methods = {"substeps"},
      .parameters = standing_parameters(
          {{"ratio", "", "of the upper box's mass to the lower's", 100, 1e-6, 1e9}}),
      .dt = 1.0 / 60,
      .duration = 10,
      .camera = {.target = {0, 1, 0}, .distance = 3.7F, .yaw = 0.5F, .pitch = 0.15F},
      .chart_metric = "sunk",
      .start = [](const Setup& setup) { return std::make_unique<MassRatio>(setup); },
  };
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
