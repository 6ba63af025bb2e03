/// @file
/// GJK and EPA between two shapes, one iteration a step, in their Minkowski difference.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "chapters/04-contacts/parts.hpp"
#include "common/physics/epa.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

/// The scene step-by-step. step_by_step.cpp moves it on, step_by_step_picture.cpp draws
/// it.
class StepByStep : public Simulation {
 public:
  explicit StepByStep(const Setup& setup);

  void step() override;
  void observe() override;
  std::vector<BodyState> bodies() const override;
  std::vector<Metric> metrics() const override;
  long long evaluations() const override { return gjk_.iterations + epa_.iterations; }
  long long body_count() const override { return 1; }
  void draw(DrawList& list) const override;
  void draw_reference(DrawList& list) const override;
  CameraPose camera(const CameraPose& usual) const override;

 private:
  double length(Real units) const { return double(units) * double(difference_.unit); }
  double radii() const { return double(difference_.a.radius + difference_.b.radius); }
  glm::vec3 in_picture(const Vec3& w) const;
  std::vector<glm::vec3> in_picture(std::span<const SupportPoint> points) const;
  bool meet() const { return !gjk_.done || cores_meet(gjk_) || !converged(); }
  bool all_flat() const;
  bool converged() const { return gjk_.reason == Reason::converged; }
  void find_hull();

  void draw_shapes(DrawList& list) const;
  void draw_support(DrawList& list) const;
  void draw_simplex(DrawList& list) const;
  void draw_polytope(DrawList& list) const;
  void tell_gjk(DrawList& list) const;
  void tell_epa(DrawList& list) const;

  Setup setup_;
  Specimen a_, b_;
  Pose pose_a_, pose_b_;
  MinkowskiDifference difference_;
  ConvexHull hull_;  ///< of the whole difference [units]
  glm::vec3 left_{0}, right_{0}, top_{0};
  std::shared_ptr<const MeshData> hull_mesh_;

  Gjk gjk_;
  Epa epa_;
  Separation answer_;  ///< of the whole query
  bool in_epa_ = false, done_ = false;
  int iteration_ = 0;

  /// What the next step is going to look at: the support point, along which normal.
  SupportPoint next_{};
  Vec3 towards_{0, 0, 1};
  Real lower_ = 0, upper_ = 0;  ///< bounds of the distance, or of the depth [units]
};

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04
