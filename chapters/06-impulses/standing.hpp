/// @file
/// Boxes that are put on each other and ought to stay: what the scenes of stacks share.
#pragma once

#include <string>
#include <vector>

#include "chapters/06-impulses/world_run.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_06 {

/// A world of boxes on a floor. Lengths are measured in `size`, that of a box.
class Standing : public WorldRun {
 protected:
  /// The scene's parameters are those of `standing_parameters` and its own. The boxes
  /// are 1 m large in the picture.
  explicit Standing(const Setup& setup);

  double size() const { return parameter("size"); }

  /// A box at a place [sizes], with its density [kg/m³] and its edges [sizes].
  void add_box(const glm::dvec3& place, const glm::dvec3& edges = glm::dvec3(1),
               double density = 1);

  void after_step() override;
  std::vector<Metric> own_metrics() const override;

  /// Of all boxes at the start, and of the last one now [m].
  double sunk() const;

 private:
  const RigidBody& box(std::size_t i) const { return body_of(world(), boxes_[i]); }
  bool stands() const;

  std::vector<BodyHandle> boxes_;
  std::vector<glm::dvec3> starts_;
  double start_energy_ = 0, drift_ = 0, worst_drift_ = 0, stood_until_ = 0;
  bool stood_ = true;
};

/// The scene's own first, then those of `with_settings`.
std::vector<Parameter> standing_parameters(std::vector<Parameter> own);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_06
