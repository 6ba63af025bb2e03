#include "chapters/06-impulses/standing.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "chapters/06-impulses/body_picture.hpp"
#include "common/graphics/palette.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

Standing::Standing(const Setup& setup)
    : WorldRun(setup, {.scale = 1 / float(setup.parameters.at("size")),
                       .lanes_apart = {0, 0, -2.5F}}) {
  // What the world's tolerances of length are for boxes of 1 m
  const Real unit = Real(parameter("unit"));
  world().margin *= unit;
  world().penetration.epsilon *= unit;
  world().penetration.slop *= unit;
  world().settings.push_speed *= std::sqrt(unit);
  world().settings.velocity_epsilon *= std::sqrt(unit);
  add("floor", RigidBody{}, floor_collider(parameter("friction"), 0), k_body);
}

void Standing::add_box(const glm::dvec3& place, const glm::dvec3& edges,
                       double density) {
  const glm::dvec3 lengths = size() * edges;
  const double mass = density * lengths.x * lengths.y * lengths.z;
  const std::size_t index = boxes_.size();
  boxes_.push_back(
      add(fmt::format("box {}", index + 1), box_body(mass, lengths, size() * place),
          box_collider(lengths, parameter("friction"), 0), body_color(index)));
  starts_.push_back(size() * place);
}

// None has fallen by half its size, or moved aside by that
bool Standing::stands() const {
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    if (!(glm::distance(place(box(i)), starts_[i]) < size() / 2)) return false;
  return true;
}

void Standing::after_step() {
  if (steps() == 0) start_energy_ = energy_of(world());
  drift_ = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const glm::dvec3 moved = place(box(i)) - starts_[i];
    drift_ = std::max(drift_, std::hypot(moved.x, moved.z));
  }
  worst_drift_ = std::max(worst_drift_, drift_);
  stood_ = stood_ && stands();
  if (stood_) stood_until_ = time();
}

double Standing::sunk() const {
  const std::size_t last = boxes_.size() - 1;
  return starts_[last].y - place(box(last)).y;
}

std::vector<Metric> Standing::own_metrics() const {
  // What its potential energy is, all boxes lifted by one size
  double weight = 0;
  for (const BodyHandle& handle : boxes_)
    weight += mass_of(body_of(world(), handle)) * parameter("gravity");
  const double energy = energy_of(world()) - start_energy_;
  return {
      {"stands", "", stands() ? 1.0 : 0.0},
      {"fallen", "", stands() ? 0.0 : 1.0},
      {"stood_until", "s", stood_until_},
      {"drift", "sizes", drift_ / size()},
      {"drift_max", "sizes", worst_drift_ / size()},
      {"sunk", "sizes", sunk() / size()},
      {"energy_change", "weights × sizes", weight > 0 ? energy / (weight * size()) : 0},
  };
}

std::vector<Parameter> standing_parameters(std::vector<Parameter> own) {
  const std::vector<Parameter> shared{
      {"size", "m", "of a box", 1, 1e-6, 1e6},
      {"unit", "m", "to which the world's tolerances of length belong", 1, 1e-6, 1e6},
      {"friction", "", "of all surfaces", 0.5, 0, 100}};
  own.insert(own.end(), shared.begin(), shared.end());
  return with_settings(std::move(own));
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
