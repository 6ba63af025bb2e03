/// @file
/// What the scenes of chapter 3 share, and each of them.
#pragma once

#include <vector>

#include "common/chapter/scene.hpp"
#include "common/physics/exact_top.hpp"
#include "common/physics/rotations.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_03 {

Scene thrown_wrench_scene();
Scene torque_free_scene();
Scene dzhanibekov_scene();
Scene symmetric_top_scene();
Scene heavy_top_scene();
Scene cue_strike_scene();
Scene spin_up_scene();

/// Every rotation method, as a scene offers it.
std::vector<Method> all_choices();

/// A simulation of one body that one rotation method turns.
class BodyRun : public Simulation {
 public:
  void step() final;
  long long evaluations() const final { return steps_ * method_.evaluations; }
  long long body_count() const final { return 1; }

 protected:
  explicit BodyRun(const Setup& setup);

  /// Moves the body by setup().dt. Throws Unsolved, which ends the run.
  virtual void advance() = 0;

  const Setup& setup() const { return setup_; }
  double parameter(const char* name) const { return setup_.parameters.at(name); }
  const RotationMethod& method() const { return method_; }
  long long steps() const { return steps_; }
  double time() const { return static_cast<double>(steps_) * setup_.dt; }

 private:
  Setup setup_;
  RotationMethod method_;
  long long steps_ = 0;
};

/// One that does nothing but turn.
class TopRun : public BodyRun {
 protected:
  /// moments: principal moments of inertia [kg m²].
  TopRun(const Setup& setup, const glm::dvec3& moments, const exact::Turning& start,
         const Torque& torque);

  void advance() override;

  const glm::dvec3& moments() const { return moments_; }
  exact::Turning now() const;

 private:
  glm::dvec3 moments_;
  Torque torque_;
  Rotation rotation_;
};

/// A rotation in double.
exact::Turning wide(const Rotation& r);

/// The moments of a scene's parameters i1, i2 and i3. Throws InputError if there is no
/// body that has them.
glm::dvec3 moments_of(const Setup& setup);

/// Vectors and transforms of a picture from those of the physics.
inline glm::vec3 picture(const glm::dvec3& v) {
  return glm::vec3(v);
}
glm::mat4 placed(const glm::vec3& at, const glm::dquat& q);

/// Where bodies stand that are shown side by side, in rows: the exact one is the first,
/// then one for each method, `apart` from each other and about the origin.
glm::vec3 place_of_exact(const Setup& setup, float apart);
glm::vec3 place_of_lane(const Setup& setup, float apart);

/// The look at all of them.
CameraPose camera_for_lanes(const CameraPose& usual, const Setup& setup, float apart);

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_03
