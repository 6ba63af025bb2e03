/// @file
/// A body that turns without torque, beside its exact motion: what the scenes
/// torque-free, dzhanibekov and symmetric-top share.
#pragma once

#include <vector>

#include "chapters/03-rigid-bodies/parts.hpp"
#include "common/chapter/trail.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {

class FreeTop : public TopRun {
 public:
  FreeTop(const Setup& setup, const glm::dvec3& moments, const exact::Turning& start);

  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 protected:
  const exact::Turning& exact_now() const { return exact_; }
  const exact::Turning& start() const { return start_; }

 private:
  /// A number, and the largest size that it has had.
  struct Tracked {
    double now = 0, largest = 0;
    void set(double value);
  };

  exact::Turning start_, exact_;
  Tracked attitude_, energy_, momentum_, momentum_length_, momentum_direction_, norm_;
  Trail herpolhode_, polhode_;  ///< tip of omega: in the world, in the body
};

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
